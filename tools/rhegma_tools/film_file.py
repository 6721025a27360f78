"""Writes a film of a run: WebM or MP4 by ffmpeg, else an animated GIF. Colours, magnification and view are the same in all frames."""

import errno
import io
import os
import shutil
import subprocess
import tempfile

import numpy as np
from PIL import Image

from rhegma.components import components_of, parts_of
from rhegma.fields import read_fields
from rhegma.problem import Problem

from . import style
from .colour_scales import add_bar, scale_of
from .field_picture import View, choose_view
from .film_frames import Sample, Stage, as_png, common_magnification, spread
from .output_file import replacing
from .quantity import label_of, quantity_shown, unit_of
from .spatial_picture import body_colours_at, camera_of, cut_text, scale_bar, triad
from .spatial_pieces import body_piece, crack_pieces, cut_open
from .style import plt
from .vtk_window import Window

KNOWN = ("principal", "mises")
SAMPLED = 24  # frames from which the scales are found
DOTS = 120  # per inch
ENCODERS = {".webm": ["-c:v", "libvpx-vp9", "-crf", "28", "-b:v", "0"], ".mp4": ["-c:v", "libx264", "-crf", "20", "-movflags", "+faststart"]}


class Wanted:
    """What a film shows. quantity: such as "principal" or "velocity:x"; magnification: a factor, or None; asked: a slice, or None; solid: a run
    in 3D as a body cut open, not as a slice; most: frames"""

    def __init__(self, quantity="principal", magnification=None, asked=None, solid=True, most=400):
        self.quantity, self.magnification, self.asked, self.solid, self.most = quantity, magnification, asked, solid, most

    @property
    def field(self):
        """The field of the particles to read in addition, or None."""
        name = parts_of(self.quantity)[0]
        return None if name in KNOWN or self.quantity == "temperature" else name


class SolidStage:
    """A figure in which one frame of a run in 3D after the other is drawn, as the body cut open."""

    def __init__(self, samples, last, quantity, magnification, asked):
        self.quantity, self.magnification, self.view = quantity, magnification, choose_view(last, asked)
        self.window = Window()
        drawn = [s.position + (magnification - 1.0) * s.displacement for s in samples]
        low, high = np.min([d.min(axis=0) for d in drawn], axis=0) - last.size, np.max([d.max(axis=0) for d in drawn], axis=0) + last.size
        self.camera, self.side = camera_of(last, self.view, magnification, bounds=(low, high))
        values = np.concatenate([s.values for s in samples])
        self.factor, self.unit = unit_of(quantity, values)
        self.colours, self.norm = scale_of(quantity, values * self.factor, last.counts, np.concatenate([s.near for s in samples]))
        self.figure, self.axes = plt.subplots(figsize=(8.2, 6.2), layout="constrained")
        self.axes.set_axis_off()
        self.shown = self.axes.imshow(np.full((self.camera.size[1], self.camera.size[0], 3), 255, dtype=np.uint8))
        triad(self.axes, self.camera)
        scale_bar(self.axes, self.camera)
        label = label_of(quantity) + (f" [{self.unit}]" if self.unit else "")
        add_bar(self.figure, plt.cm.ScalarMappable(self.norm, self.colours), self.axes, label, shrink=0.7, aspect=26, pad=0.02)

    def __enter__(self):
        self.window.__enter__()
        return self

    def __exit__(self, *_):
        self.window.__exit__()
        plt.close(self.figure)

    def draw(self, fields, clock, more="", dots=DOTS):
        """A frame as a PNG, or None where VTK draws nothing."""
        kept = cut_open(fields, self.view.normal, self.view.where, self.side)
        kept = np.arange(len(fields.position)) if len(kept) == 0 else kept
        colours = body_colours_at(fields.values(self.quantity) * self.factor, self.colours, self.norm)
        image = self.window.render([body_piece(fields, kept, self.magnification, colours)] + crack_pieces(fields, self.magnification), self.camera)
        if image is None:
            return None
        self.shown.set_data(image)
        self.axes.set_title(f"t = {fields.time * clock[0]:.4g} {clock[1]}{more}, {cut_text(self.view, self.side)}", fontsize=10, fontweight="normal")
        return as_png(self.figure, dots)


def read_frame(folder, wanted, time=None):
    fields = read_fields(folder, time, wanted.field)
    if fields is not None and fields.values(wanted.quantity) is None:
        if wanted.quantity == "temperature":
            raise Problem("the run has no temperature.")
        names = components_of(fields.chosen)
        needed = f"{wanted.field}:COMPONENT with one of the components {', '.join(names)}" if names else wanted.field
        raise Problem(f"{wanted.quantity} is no quantity to draw; write {needed}.")
    return fields


class Film:
    """frames: [(time [s], PNG)]; magnification; label, unit, low, high: of the colours; solid: as a body cut open"""

    def __init__(self, frames, magnification, stage, solid):
        self.frames, self.magnification, self.solid = frames, magnification, solid
        self.label, self.unit = label_of(stage.quantity), stage.unit
        self.low, self.high, self.norm, self.colours = float(stage.norm.vmin), float(stage.norm.vmax), stage.norm, stage.colours


def draw_frames(folder, wanted, say=lambda text: None):
    """The frames of a run as a Film. say: gets a line after each frame"""
    last = read_frame(folder, wanted)
    if last is None:
        raise Problem(f"{folder} has no fields.h5; give the folder that a run wrote.")
    if len(last.written) < 2:
        raise Problem("the run has fields of one time only; write Output > Field Interval, so that there are frames.")
    wanted.quantity = quantity_shown(last, wanted.quantity)
    times = spread(last.written, wanted.most)
    view = choose_view(last, wanted.asked)
    solid = wanted.solid and last.dimension == 3
    seen = View([0, 1, 2]) if solid else view
    samples = [Sample(read_frame(folder, wanted, time), seen, wanted.quantity) for time in spread(times, SAMPLED)]
    samples = [sample for sample in samples if len(sample.position)]
    if not samples:
        raise Problem("no frame has particles in the section that is drawn.")
    magnification = wanted.magnification or common_magnification(samples)
    clock = style.scale(max(abs(time) for time in times), "s")
    more = ",  true displacement" if magnification == 1.0 else f",  displacement × {magnification:,.7g}"
    stage = SolidStage(samples, last, wanted.quantity, magnification, wanted.asked) if solid else Stage(samples, view, wanted.quantity, magnification)
    frames = []
    with stage:
        for time in times:
            frames.append((time, stage.draw(read_frame(folder, wanted, time), clock, more, DOTS)))
            if frames[-1][1] is None:
                return None
            say(f"frame {len(frames)} of {len(times)}")
    return Film(frames, magnification, stage, solid)


def encode(frames, temporary, path, per_second):
    """Writes WebM or MP4 by ffmpeg. path: of the film, for messages"""
    with tempfile.TemporaryDirectory(prefix="rhegma-film-") as folder:
        for i, (_, png) in enumerate(frames):
            with open(os.path.join(folder, f"{i:05d}.png"), "wb") as file:
                file.write(png)
        even = "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white"
        command = ["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(per_second), "-i", os.path.join(folder, "%05d.png"), "-vf", even,
                   "-pix_fmt", "yuv420p", *ENCODERS[os.path.splitext(path)[1]], temporary]
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, errors="replace")
    if result.returncode != 0:
        reason = (result.stderr.strip().splitlines() or ["no reason given"])[-1]
        space = os.strerror(errno.ENOSPC)  # which a GIF needs, too
        if space in result.stderr:
            raise Problem(f"{path} can't be written ({space}).")
        raise Problem(f"{path} can't be written by ffmpeg ({reason}); a name that ends with .gif needs no ffmpeg.")


def animate(frames, path, per_second):
    """Writes an animated GIF with one palette."""
    pictures = [Image.open(io.BytesIO(png)).convert("RGB") for _, png in frames]
    palette = pictures[-1].quantize(256, dither=Image.Dither.NONE)
    shown = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    shown[0].save(path, save_all=True, append_images=shown[1:], duration=round(1000 / per_second), loop=0)


def default_path(folder):
    return os.path.join(folder, "film.webm" if shutil.which("ffmpeg") else "film.gif")


def write_film(frames, path, per_second):
    """Writes frames [(time, PNG)] in the format that the name of the file asks for."""
    ending = os.path.splitext(path)[1]
    if ending not in (".gif", *ENCODERS):
        raise Problem(f"{path}: the name of a film ends with .webm, .mp4 or .gif.")
    if ending != ".gif" and shutil.which("ffmpeg") is None:
        raise Problem(f"{path}: WebM and MP4 need ffmpeg (on Debian or Ubuntu: apt-get install ffmpeg); a name that ends with .gif needs none.")
    with replacing(path) as temporary:
        if ending == ".gif":
            animate(frames, temporary, per_second)
        else:
            encode(frames, temporary, path, per_second)
