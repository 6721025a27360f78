"use strict";
// Draws the panels of the page so that they zoom, lets the reader choose columns of the history, and shows the film's frames.
// Without this script the page has still pictures of all panels. The body's attribute data-script is "ready" at its end.
(function () {
  const INK = "#222222", QUIET = "#dddddd", FRAME = "#555555";
  const LEFT = 72, RIGHT = 26, TOP = 28, BOTTOM = 44; // margins of a plot [px]
  const SMALLEST = 1e-9; // visible part of an axis
  const SAME = 0.02; // smallest range of an axis of chosen columns, over the size of its values
  const holder = document.createElement("div");
  holder.innerHTML = "<svg></svg>";
  const SVG = holder.firstChild.namespaceURI;
  let count = 0;

  window.addEventListener("error", (event) => { document.body.dataset.error = event.message; });

  /** An element inside another. name: of the element; attributes: {name: value}; space: SVG, or undefined for HTML */
  function add(parent, name, attributes, space) {
    const made = space ? document.createElementNS(space, name) : document.createElement(name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    parent.appendChild(made);
    return made;
  }

  /** The data in the element that a figure names. */
  function dataOf(figure) {
    return JSON.parse(document.getElementById(figure.dataset.source).textContent);
  }

  /** Round numbers between two ends, at most about so many. */
  function ticks(low, high, most) {
    const exact = (high - low) / Math.max(most, 1);
    const power = Math.pow(10, Math.floor(Math.log10(exact)));
    const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= exact * (1 - 1e-9));
    const found = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
    return { step, values: found };
  }

  /** A tick's number, with the digits that its step needs. */
  function tickText(value, step, largest) {
    if (Math.abs(value) < 1e-6 * step) return "0";
    const order = Math.floor(Math.log10(step) + 1e-9);
    if (largest >= 1e6 || step < 1e-4) {
      return value.toExponential(Math.max(Math.floor(Math.log10(Math.abs(value)) + 1e-9) - order, 0)).replace("-", "\u2212").replace("e-", "e\u2212").replace("e+", "e");
    }
    return value.toFixed(Math.max(-order, 0)).replace("-", "\u2212");
  }

  function readable(value) {
    return value === null ? "no number" : String(Number(value.toPrecision(5))).replace("-", "\u2212");
  }

  /** A plot that zooms. box: its element; data: as zoom_data.py writes it. */
  class Plot {
    constructor(box, data, label) {
      this.box = box;
      this.name = "clip-" + count++;
      box.classList.add("plot");
      box.tabIndex = 0;
      box.setAttribute("role", "group");
      box.setAttribute("aria-label", label + ". Plus and minus zoom, arrows move, 0 shows all.");
      this.svg = add(box, "svg", {}, SVG);
      this.legend = add(box, "ul", { class: "legend" });
      this.take(data);
      this.listen();
    }

    take(data) {
      this.data = data;
      this.view = data.range.slice();
      this.writeLegend();
      this.draw();
    }

    // Positions on the screen of values, and values of positions.
    x(value) { return LEFT + (value - this.view[0]) / (this.view[1] - this.view[0]) * this.inner[0]; }
    y(value) { return TOP + (this.view[3] - value) / (this.view[3] - this.view[2]) * this.inner[1]; }
    valueX(at) { return this.view[0] + (at - LEFT) / this.inner[0] * (this.view[1] - this.view[0]); }
    valueY(at) { return this.view[3] - (at - TOP) / this.inner[1] * (this.view[3] - this.view[2]); }

    draw() {
      const width = Math.max(this.box.clientWidth || 720, 260);
      const height = Math.round(Math.min(Math.max(0.42 * width, 230), 360));
      this.inner = [width - LEFT - RIGHT, height - TOP - BOTTOM];
      this.svg.setAttribute("viewBox", "0 0 " + width + " " + height);
      this.svg.textContent = "";
      const clip = add(add(this.svg, "clipPath", { id: this.name }, SVG), "rect", {}, SVG);
      this.frame = { x: LEFT, y: TOP, width: this.inner[0], height: this.inner[1] };
      for (const key in this.frame) clip.setAttribute(key, this.frame[key]);
      this.drawAxes(width, height);
      const inside = add(this.svg, "g", { "clip-path": "url(#" + this.name + ")" }, SVG);
      if (this.data.map) this.drawMap(inside);
      this.drawBackground(inside);
      for (const curve of this.data.curves) this.line(inside, this.path(curve.x, curve.y), curve);
      for (const bar of this.data.bars) {
        const x = this.x(bar.x), low = this.y(bar.low), high = this.y(bar.high);
        this.line(inside, `M${x},${low}V${high}M${x - 5},${low}h10M${x - 5},${high}h10`, { colour: bar.colour, dashes: "", width: 1.4 });
      }
      this.cursor = add(this.svg, "line", { y1: TOP, y2: TOP + this.inner[1], stroke: FRAME, "stroke-width": 0.8, visibility: "hidden" }, SVG);
      this.chosen = add(this.svg, "rect", { fill: "#56b4e9", opacity: 0.25, visibility: "hidden" }, SVG);
    }

    drawAxes(width, height) {
      const [x0, x1, y0, y1] = this.view, bottom = TOP + this.inner[1];
      const across = ticks(x0, x1, this.inner[0] / 85), up = ticks(y0, y1, this.inner[1] / 45);
      const text = (x, y, content, more) => { add(this.svg, "text", Object.assign({ x, y }, more), SVG).textContent = content; };
      for (const value of across.values) {
        add(this.svg, "line", { x1: this.x(value), x2: this.x(value), y1: TOP, y2: bottom, stroke: QUIET, "stroke-width": 0.7 }, SVG);
        text(this.x(value), bottom + 16, tickText(value, across.step, Math.max(Math.abs(x0), Math.abs(x1))), { "text-anchor": "middle" });
      }
      for (const value of up.values) {
        add(this.svg, "line", { x1: LEFT, x2: width - RIGHT, y1: this.y(value), y2: this.y(value), stroke: QUIET, "stroke-width": 0.7 }, SVG);
        text(LEFT - 6, this.y(value) + 4, tickText(value, up.step, Math.max(Math.abs(y0), Math.abs(y1))), { "text-anchor": "end" });
      }
      this.line(this.svg, `M${LEFT},${TOP}V${bottom}H${width - RIGHT}`, { colour: FRAME, dashes: "", width: 1 });
      text(LEFT, 17, this.data.title, { class: "title" });
      text(LEFT + this.inner[0] / 2, height - 8, this.data.x, { "text-anchor": "middle" });
      const middle = TOP + this.inner[1] / 2;
      text(14, middle, this.data.y, { "text-anchor": "middle", transform: `rotate(-90 14 ${middle})` });
    }

    /** Rectangles of a map in colours, as one picture: an element for each would be thousands. */
    drawMap(inside) {
      const sharp = 2, canvas = document.createElement("canvas"), pen = canvas.getContext("2d");
      [canvas.width, canvas.height] = this.inner.map((size) => Math.round(sharp * size));
      const to = (at, begin) => sharp * (at - begin);
      for (const strip of this.data.map.strips) {
        const top = to(this.y(strip.t[1]), TOP), bottom = to(this.y(strip.t[0]), TOP);
        if (bottom < 0 || top > canvas.height) continue;
        strip.v.forEach((value, i) => {
          const left = to(this.x(strip.s[i]), LEFT), right = to(this.x(strip.s[i + 1]), LEFT);
          if (right < 0 || left > canvas.width) return;
          pen.fillStyle = this.colour(value);
          pen.fillRect(Math.floor(left), Math.floor(top), Math.ceil(right) - Math.floor(left), Math.ceil(bottom) - Math.floor(top));
        });
      }
      add(inside, "image", { x: LEFT, y: TOP, width: this.inner[0], height: this.inner[1], preserveAspectRatio: "none", href: canvas.toDataURL() }, SVG);
    }

    /** Colour of a value of a map. */
    colour(value) {
      const { low, high, colours, without } = this.data.map;
      if (value === null) return without;
      const part = Math.min(Math.max((value - low) / (high - low), 0), 1);
      return colours[Math.round(part * (colours.length - 1))];
    }

    /** Value of a map at a position in its own units; undefined where it has none. */
    mapValue(s, t) {
      for (const strip of this.data.map.strips) {
        if (t < strip.t[0] || t > strip.t[1]) continue;
        for (let i = 0; i < strip.v.length; i++) if (s >= strip.s[i] && s <= strip.s[i + 1]) return strip.v[i];
      }
      return undefined;
    }

    drawBackground(inside) {
      const across = `H${LEFT + this.inner[0]}`;
      for (const band of this.data.bands) {
        const top = this.y(band.high);
        add(inside, "rect", { x: LEFT, width: this.inner[0], y: top, height: Math.max(this.y(band.low) - top, 0), fill: "#000000", opacity: 0.1 }, SVG);
      }
      for (const area of this.data.areas) {
        add(inside, "path", { d: this.path(area.x, area.y) + "Z", fill: area.colour, opacity: area.opacity }, SVG);
      }
      for (const one of this.data.across) this.line(inside, `M${LEFT},${this.y(one.at)}${across}`, one);
      for (const one of this.data.marks) this.line(inside, `M${this.x(one.at)},${TOP}V${TOP + this.inner[1]}`, one);
    }

    line(parent, path, look) {
      add(parent, "path", { d: path, fill: "none", stroke: look.colour, "stroke-width": look.width, "stroke-dasharray": look.dashes || "none",
        "stroke-linejoin": "round" }, SVG);
    }

    /** Straight lines through points; an interruption where a number is missing. A point between two such is a short line. */
    path(x, y) {
      let text = "", pen = false;
      for (let i = 0; i < x.length; i++) {
        if (x[i] === null || y[i] === null) { pen = false; continue; }
        const at = this.x(x[i]).toFixed(1) + "," + this.y(y[i]).toFixed(1);
        text += (pen ? "L" : "M") + at;
        if (!pen && (i + 1 === x.length || y[i + 1] === null)) text += "h2";
        pen = true;
      }
      return text;
    }

    writeLegend() {
      this.legend.textContent = "";
      this.outputs = [];
      const entry = (look, fill) => {
        const item = add(this.legend, "li", {});
        const swatch = add(item, "svg", { viewBox: "0 0 30 10", "aria-hidden": "true" }, SVG);
        if (fill) add(swatch, "rect", { width: 30, height: 10, fill: look.colour, opacity: look.opacity }, SVG);
        else this.line(swatch, "M0,5H30", look);
        item.appendChild(document.createTextNode(look.name));
        return item;
      };
      if (this.data.map) {
        const { name, low, high, colours } = this.data.map, item = add(this.legend, "li", {});
        item.appendChild(document.createTextNode(readable(low) + " "));
        const scale = add(item, "svg", { viewBox: "0 0 " + colours.length + " 4", class: "scale", preserveAspectRatio: "none", "aria-hidden": "true" }, SVG);
        colours.forEach((fill, i) => add(scale, "rect", { x: i, width: 1.1, height: 4, fill }, SVG));
        item.appendChild(document.createTextNode(readable(high) + "  " + name));
        this.mapOutput = add(item, "output", {});
      }
      for (const curve of this.data.curves) this.outputs.push(curve.name ? add(entry(curve), "output", {}) : null);
      for (const look of this.data.across.concat(this.data.marks)) if (look.name) entry(look);
      for (const area of this.data.areas) if (area.name) entry(area, true);
    }

    /** Position of an event in the plot's own units. */
    at(event) {
      const box = this.svg.getBoundingClientRect(), scale = (this.inner[0] + LEFT + RIGHT) / box.width;
      return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
    }

    listen() {
      let start = null;
      this.svg.addEventListener("wheel", (event) => {
        if (!this.box.classList.contains("active")) return; // else the page could not be scrolled past its plots
        event.preventDefault();
        const at = this.at(event), by = Math.exp(0.0015 * (event.deltaY || event.deltaX));
        if (event.shiftKey) this.zoom(2, this.valueY(at[1]), by); else this.zoom(0, this.valueX(at[0]), by);
        this.draw();
      }, { passive: false });
      this.svg.addEventListener("pointerdown", (event) => {
        this.box.focus();
        this.box.classList.add("active");
        start = this.at(event);
        try { this.svg.setPointerCapture(event.pointerId); } catch (error) { start = this.at(event); }
      });
      this.svg.addEventListener("pointermove", (event) => {
        if (start) this.choose(start, this.at(event)); else this.read(this.at(event));
      });
      this.svg.addEventListener("pointerup", (event) => {
        if (start) this.finish(start, this.at(event));
        start = null;
      });
      this.svg.addEventListener("pointercancel", () => { start = null; this.draw(); });
      this.svg.addEventListener("pointerleave", () => this.read(null));
      this.svg.addEventListener("dblclick", () => this.reset());
      this.box.addEventListener("blur", () => this.box.classList.remove("active"));
      this.box.addEventListener("keydown", (event) => this.key(event));
    }

    reset() {
      this.view = this.data.range.slice();
      this.draw();
    }

    /** Scales an axis about a value. axis: 0 across, 2 up */
    zoom(axis, about, by) {
      const [low, high] = this.data.range.slice(axis, axis + 2), whole = high - low;
      const width = Math.min(Math.max((this.view[axis + 1] - this.view[axis]) * by, SMALLEST * whole), whole);
      const part = (about - this.view[axis]) / (this.view[axis + 1] - this.view[axis]);
      this.shift(axis, about - part * width, width);
    }

    /** Sets an axis to a lower end and a width, inside its whole range. */
    shift(axis, from, width) {
      const [low, high] = this.data.range.slice(axis, axis + 2);
      this.view[axis] = Math.min(Math.max(from, low), high - width);
      this.view[axis + 1] = this.view[axis] + width;
    }

    key(event) {
      const width = this.view[1] - this.view[0], middle = 0.5 * (this.view[0] + this.view[1]);
      const acts = {
        "+": () => this.zoom(0, middle, 0.7), "=": () => this.zoom(0, middle, 0.7), "-": () => this.zoom(0, middle, 1 / 0.7),
        ArrowLeft: () => this.shift(0, this.view[0] - 0.2 * width, width), ArrowRight: () => this.shift(0, this.view[0] + 0.2 * width, width),
        0: () => this.reset(), Escape: () => this.reset(),
      };
      if (!acts[event.key] || event.ctrlKey || event.metaKey || event.altKey || event.target !== this.box) return;
      event.preventDefault();
      acts[event.key]();
      this.draw();
    }

    /** What a drag selects: a range across, and up where it is high enough. */
    selection(start, end) {
      const inside = (at) => [Math.min(Math.max(at[0], LEFT), LEFT + this.inner[0]), Math.min(Math.max(at[1], TOP), TOP + this.inner[1])];
      const [a, b] = [inside(start), inside(end)], tall = Math.abs(a[1] - b[1]) > 25;
      return { left: Math.min(a[0], b[0]), right: Math.max(a[0], b[0]), tall,
        top: tall ? Math.min(a[1], b[1]) : TOP, bottom: tall ? Math.max(a[1], b[1]) : TOP + this.inner[1] };
    }

    choose(start, end) {
      const s = this.selection(start, end);
      const shape = { x: s.left, y: s.top, width: s.right - s.left, height: s.bottom - s.top, visibility: "visible" };
      for (const key in shape) this.chosen.setAttribute(key, shape[key]);
    }

    finish(start, end) {
      const s = this.selection(start, end);
      if (s.right - s.left > 8) {
        const [x0, x1, y0, y1] = [this.valueX(s.left), this.valueX(s.right), this.valueY(s.bottom), this.valueY(s.top)];
        if (x1 - x0 > SMALLEST * (this.data.range[1] - this.data.range[0])) this.view.splice(0, 2, x0, x1);
        if (s.tall) this.view.splice(2, 2, y0, y1);
      }
      this.draw();
    }

    /** Writes the values of curves nearest to a position into the legend. */
    read(at) {
      const shown = at && at[0] >= LEFT && at[0] <= LEFT + this.inner[0];
      this.cursor.setAttribute("visibility", shown ? "visible" : "hidden");
      if (shown) { this.cursor.setAttribute("x1", at[0]); this.cursor.setAttribute("x2", at[0]); }
      if (this.data.map) {
        const value = shown ? this.mapValue(this.valueX(at[0]), this.valueY(at[1])) : undefined;
        this.mapOutput.textContent = value === undefined ? "" : readable(value) + " at " + readable(this.valueX(at[0])) + ", " + readable(this.valueY(at[1]));
      }
      this.data.curves.forEach((curve, k) => {
        if (!this.outputs[k]) return;
        let best = -1, distance = Infinity;
        for (let i = 0; shown && i < curve.x.length; i++) {
          const d = curve.x[i] === null ? Infinity : Math.abs(curve.x[i] - this.valueX(at[0]));
          if (d < distance) { distance = d; best = i; }
        }
        this.outputs[k].textContent = best < 0 ? "" : readable(curve.y[best]) + " at " + readable(curve.x[best]);
      });
    }
  }

  /** Lowest and highest of numbers, with a margin. */
  function rangeOf(lists, margin) {
    let low = Infinity, high = -Infinity;
    for (const list of lists) for (const value of list) if (value !== null) { low = Math.min(low, value); high = Math.max(high, value); }
    if (low > high) return [0, 1];
    const least = Math.max(SAME * Math.max(Math.abs(low), Math.abs(high)), 1e-300) * (margin > 0 ? 1 : 1e-6);
    if (high - low < least) [low, high] = [0.5 * (low + high - least), 0.5 * (low + high + least)];
    return [low - margin * (high - low), high + margin * (high - low)];
  }

  /** A plot of columns that the reader chooses. box: where it is made */
  function makeChooser(box) {
    const { columns, colours } = dataOf(box), names = Object.keys(columns);
    const choices = add(box, "div", { class: "choices" });
    const list = (text, attributes) => {
      const label = add(choices, "label", {});
      label.textContent = text;
      const select = add(label, "select", attributes);
      for (const name of names) add(select, "option", { value: name }).textContent = name;
      return select;
    };
    const up = list("Columns (Ctrl or Cmd and click for several)", { multiple: "", size: Math.min(8, names.length) });
    const across = list("Horizontal axis", {});
    across.value = names.includes("time") ? "time" : names[0];
    const changes = (name) => columns[name].some((value) => value !== null && value !== columns[name][0]);
    const first = names.find((name) => name.endsWith(".G_J")) || ["strain", "temperature_highest"].find((name) => names.includes(name) && changes(name))
      || names.find((name) => name !== "time" && changes(name)) || names.find((name) => name !== "time");
    for (const option of up.options) option.selected = option.value === first;
    const data = () => {
      const chosen = Array.from(up.selectedOptions, (option) => option.value), x = columns[across.value];
      const curves = chosen.map((name, i) => ({ name, colour: colours[i % colours.length], dashes: ["", "7 3", "2 3"][Math.floor(i / colours.length) % 3],
        width: 1.6, x, y: columns[name] }));
      return { title: "", x: across.value, y: chosen.length === 1 ? chosen[0] : "value", curves, across: [], marks: [], bands: [], areas: [], bars: [],
        range: rangeOf([x], 0).concat(rangeOf(chosen.map((name) => columns[name]), 0.05)) };
    };
    const plot = new Plot(add(box, "div", {}), data(), "Chosen columns of the history");
    for (const select of [up, across]) select.addEventListener("change", () => plot.take(data()));
    return plot;
  }

  /** Shows one frame at a time, with a slider and a button that plays. */
  function makeFilm(figure) {
    const frames = Array.from(figure.querySelectorAll(".frames img")), controls = figure.querySelector(".controls");
    figure.classList.add("live");
    const button = add(controls, "button", { type: "button" });
    const slider = add(controls, "input", { type: "range", min: 0, max: frames.length - 1, "aria-label": "frame" });
    const time = add(controls, "output", {});
    let timer = null;
    const show = () => {
      frames.forEach((frame, i) => frame.classList.toggle("shown", i === Number(slider.value)));
      time.textContent = frames[slider.value].dataset.label;
    };
    const play = (on) => {
      clearInterval(timer);
      timer = on ? setInterval(() => { slider.value = (Number(slider.value) + 1) % frames.length; show(); }, 200) : null;
      button.textContent = on ? "Stop" : "Play";
    };
    slider.value = frames.length - 1;
    slider.addEventListener("input", () => { play(false); show(); });
    button.addEventListener("click", () => play(timer === null));
    play(false);
    show();
  }

  const plots = [];
  for (const figure of document.querySelectorAll("figure.panel")) {
    const still = figure.querySelector("img.still"), box = document.createElement("div");
    figure.insertBefore(box, still);
    plots.push(new Plot(box, dataOf(figure), still.alt));
    still.remove();
  }
  document.querySelectorAll(".chooser").forEach((box) => plots.push(makeChooser(box)));
  document.querySelectorAll("figure.film").forEach(makeFilm);
  let asked = false;
  window.addEventListener("resize", () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => { asked = false; plots.forEach((plot) => plot.draw()); });
  });
  document.body.dataset.script = "ready";
})();
