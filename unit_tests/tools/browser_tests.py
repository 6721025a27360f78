"""Tests of the script in pages of rhegma-report, in a browser. Skipped where there is no chromium."""

import html
import json
import os
import re
import shutil
import subprocess
import unittest

from tool import ToolTest, run  # first, as it finds the Python for all others

import made_up_run
from report_tests import frames_of_beam

BROWSER = next((path for path in map(shutil.which, ("chromium", "chromium-browser", "google-chrome")) if path), None)

# What a reader does, and what the page then shows; written to an attribute of the body.
STEPS = """
(function () {
  const seen = {}, plot = document.querySelector(".plot"), svg = plot.querySelector("svg");
  const box = svg.getBoundingClientRect();
  const at = (x, y) => ({ clientX: box.left + x * box.width, clientY: box.top + y * box.height, bubbles: true, cancelable: true, pointerId: 1 });
  const ticks = () => Array.from(svg.querySelectorAll("text[text-anchor=middle]"), (text) => text.textContent).join(" ");
  const wheel = (x) => svg.dispatchEvent(new WheelEvent("wheel", Object.assign(at(x, 0.5), { deltaY: -600 })));
  const pointer = (name, x, y) => svg.dispatchEvent(new PointerEvent(name, at(x, y)));
  seen.whole = ticks();
  wheel(0.5);
  seen.idle = ticks();
  pointer("pointerdown", 0.5, 0.5); pointer("pointerup", 0.5, 0.5);
  wheel(0.5);
  seen.wheel = ticks();
  svg.dispatchEvent(new MouseEvent("dblclick", at(0.5, 0.5)));
  seen.reset = ticks();
  pointer("pointerdown", 0.4, 0.5); pointer("pointermove", 0.6, 0.5); pointer("pointerup", 0.6, 0.5);
  seen.drag = ticks();
  plot.dispatchEvent(new KeyboardEvent("keydown", { key: "0", bubbles: true }));
  seen.key = ticks();
  pointer("pointermove", 0.95, 0.5);
  seen.values = plot.querySelector("output").textContent;
  const lists = document.querySelectorAll(".chooser select");
  for (const option of lists[0].options) option.selected = ["strain", "kinetic"].includes(option.value);
  lists[0].dispatchEvent(new Event("change"));
  seen.chosen = Array.from(document.querySelectorAll(".chooser .legend li"), (item) => item.textContent);
  lists[1].value = "strain";
  lists[1].dispatchEvent(new Event("change"));
  seen.across = Array.from(document.querySelectorAll(".chooser .plot text"), (text) => text.textContent).includes("strain");
  const slider = document.querySelector(".film input"), shown = () => Array.from(document.querySelectorAll(".frames img"), (i) => getComputedStyle(i).display);
  seen.last = shown().join(" ");
  slider.value = 1;
  slider.dispatchEvent(new Event("input"));
  seen.second = shown().join(" ");
  seen.time = document.querySelector(".film output").textContent;
  seen.stills = document.querySelectorAll("img.still").length;
  seen.figures = document.querySelectorAll("figure.panel").length;
  document.body.dataset.seen = JSON.stringify(seen);
})();
"""

# The same with a map of values along a front.
MAP_STEPS = """
(function () {
  const seen = {}, figure = Array.from(document.querySelectorAll("figure.panel")).find((one) => one.textContent.includes("K_I [MPa √m] along Penny"));
  const plot = figure.querySelector(".plot"), svg = plot.querySelector(":scope > svg"), box = svg.getBoundingClientRect();
  const at = (x, y) => ({ clientX: box.left + x * box.width, clientY: box.top + y * box.height, bubbles: true, cancelable: true, pointerId: 1 });
  const pointer = (name, x, y) => svg.dispatchEvent(new PointerEvent(name, at(x, y)));
  const ticks = () => Array.from(svg.querySelectorAll("text[text-anchor=middle]"), (text) => text.textContent).join(" ");
  const image = () => svg.querySelector("image").getAttribute("href");
  seen.ticks = ticks();
  const whole = image();
  pointer("pointermove", 0.15, 0.8);
  seen.early = plot.querySelector("output").textContent;
  pointer("pointermove", 0.9, 0.15);
  seen.late = plot.querySelector("output").textContent;
  pointer("pointermove", 0.9, 0.8);
  seen.none = plot.querySelector("output").textContent;
  seen.legend = plot.querySelector(".legend li").textContent;
  pointer("pointerdown", 0.3, 0.3); pointer("pointermove", 0.5, 0.6); pointer("pointerup", 0.5, 0.6);
  seen.zoomed = ticks();
  seen.redrawn = image() !== whole;
  svg.dispatchEvent(new MouseEvent("dblclick", at(0.5, 0.5)));
  seen.reset = ticks();
  seen.same = image() === whole;
  document.body.dataset.seen = JSON.stringify(seen);
})();
"""


@unittest.skipUnless(BROWSER, "there is no chromium")
class Browser(ToolTest):
    def body(self, text):
        """Attributes of the body of a page once its scripts have run."""
        page = self.write("in_browser.html", text)
        answer = self.browse(page, "--window-size=1000,900", "--dump-dom")
        found = re.search(r"<body([^>]*)>", answer.stdout)
        self.assertTrue(found, answer.stderr[-2000:])
        return {name: html.unescape(value) for name, value in re.findall(r'data-(\w+)="([^"]*)"', found[1])}

    def browse(self, page, *options):
        command = [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", f"--user-data-dir={self.path('profile')}",
                   *options, "file://" + os.path.abspath(page)]
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", timeout=300)

    def page(self):
        status, _, messages = run("rhegma-report", self.folder)
        self.assertEqual((status, messages), (0, ""))
        with open(self.path("report.html"), encoding="utf-8") as file:
            return file.read()

    def test_script_runs_without_error(self):
        """Of a run with everything, one whose names are hostile, and one without history and fields."""
        made_up_run.beam(self.folder)
        self.assertEqual(self.body(self.page()), {"script": "ready"})
        name = "<b>&\"'</script><img src=x onerror=alert(1)>"
        made_up_run.write_history(self.folder, {"time": [0.0, 1.0], f"{name}.0.G_J": [float("nan"), 1.0], "strain": [0.0, 0.0]})
        made_up_run.write_summary(self.folder, scene=name, cracks=[{"name": name, "fronts": [{"position": [0.0, 0.0], "G_J": 1.0}]}])
        self.assertEqual(self.body(self.page()), {"script": "ready"})
        os.remove(self.path("history.csv"))
        os.remove(self.path("fields.h5"))
        self.assertEqual(self.body(self.page()), {"script": "ready"})

    def test_it_prints(self):
        """To PDF, on several pages with its pictures."""
        made_up_run.beam(self.folder)
        frames_of_beam(self.folder, 3)
        page = self.write("to_print.html", self.page())
        answer = self.browse(page, f"--print-to-pdf={self.path('report.pdf')}")
        with open(self.path("report.pdf"), "rb") as file:
            data = file.read()
        self.assertTrue(data.startswith(b"%PDF-") and data.rstrip().endswith(b"%%EOF"), answer.stderr[-2000:])
        self.assertGreaterEqual(len(re.findall(rb"/Type ?/Page\b", data)), 2)
        self.assertGreaterEqual(len(re.findall(rb"/Subtype ?/Image\b", data)), 2)

    def test_reader_zooms_chooses_and_plays(self):
        made_up_run.beam(self.folder)
        frames_of_beam(self.folder, 3)
        text = self.page()
        end = text.rindex("</body>")
        seen = json.loads(self.body(text[:end] + "<script>" + STEPS + "</script>" + text[end:])["seen"])
        self.assertIn("time [ms]", seen["whole"])
        self.assertEqual((seen["idle"], seen["reset"], seen["key"]), (seen["whole"],) * 3)
        for action in ("wheel", "drag"):
            self.assertNotEqual(seen[action], seen["whole"])
            times = [float(word) for word in seen[action].split() if re.fullmatch(r"[\d.]+", word)]
            self.assertTrue(times and min(times) > 0.5 and max(times) < 2.5, seen[action])  # about the middle of 0 to 3 ms
        # Near the end, 2.9 ms, the made-up beam has settled to within exp(-7.2) of 500 mJ/m2.
        value, time = re.fullmatch(r"([\d.]+) at ([\d.]+)", seen["values"]).groups()
        self.assertAlmostEqual(float(value), 500.0, delta=1.0)
        self.assertAlmostEqual(float(time), 2.9, delta=0.1)
        self.assertEqual(seen["chosen"], ["kinetic", "strain"])
        self.assertTrue(seen["across"])
        self.assertEqual((seen["last"], seen["second"], seen["time"]), ("none none block", "none block none", "t = 1 ms"))
        self.assertEqual(seen["stills"], 0)
        self.assertGreater(seen["figures"], 1)

    def test_maps_along_fronts_zoom(self):
        """A front of 1 mm at 1 us that is 2 mm long at 6 us, with a K_I of 1 MPa sqrt(m) at first and 6 MPa sqrt(m) at last."""
        made_up_run.penny(self.folder)
        samples = [(1e-6 * k, {"Penny.0": {"s": [0.0, 1e-4 * (k + 4), 2e-4 * (k + 4)], "G": [1.0] * 3, "K_I": [1e6 * k] * 3}})
                   for k in range(1, 7)]
        made_up_run.write_fronts(self.folder, samples)
        text = self.page()
        end = text.rindex("</body>")
        body = self.body(text[:end] + "<script>" + MAP_STEPS + "</script>" + text[end:])
        self.assertNotIn("error", body)
        seen = json.loads(body["seen"])
        self.assertIn("arc length [mm]", seen["ticks"])
        for when, value in (("early", 1.0), ("late", 6.0)):
            found = re.fullmatch(r"([\d.]+) at ([\d.]+), ([\d.]+)", seen[when])
            self.assertTrue(found, seen)
            self.assertAlmostEqual(float(found[1]), value, delta=1.0)
        self.assertEqual(seen["none"], "")
        self.assertIn("K_I [MPa √m]", seen["legend"])
        self.assertNotEqual(seen["zoomed"], seen["ticks"])
        self.assertTrue(seen["redrawn"])
        self.assertEqual((seen["reset"], seen["same"]), (seen["ticks"], True))


del ToolTest  # so that importing this module's names brings tests only
if __name__ == "__main__":
    unittest.main()
