"""Pictures in 3D by VTK in a process of its own, on a virtual display where there is one."""

import importlib.util
import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading

import numpy as np

from .interpreter import SYSTEM_PYTHON

CHILD = os.path.join(os.path.dirname(os.path.realpath(__file__)), "vtk_child.py")
INSTALL = ("Pictures in 3D need VTK for Python and a virtual display; on Debian or Ubuntu: apt-get install python3-vtk9 xvfb "
           "(python3-paraview has VTK, too).")
LONGEST = 600  # s for a picture


class Piece:
    """Polygons or lines in 3D. points (v, 3), cells (k, corners), colours: (k, 3) or one (3), from 0 to 255; look: opacity, lines, width
    [pixels], tube (radius of lines), flat (without light)"""

    def __init__(self, points, cells, colours, **look):
        self.points, self.cells, self.look = np.asarray(points, dtype=float), np.asarray(cells, dtype=np.int64), look
        self.colours = np.broadcast_to(np.asarray(colours, dtype=np.uint8), (len(self.cells), 3))


class Level(Piece):
    """The surface on which a field on a lattice has a value. values: (nx, ny, nz); origin (3): the first node; spacing: of the lattice"""

    def __init__(self, values, origin, spacing, level, colour, **look):
        lattice = {"shape": list(values.shape), "origin": [float(x) for x in origin], "spacing": float(spacing), "level": float(level)}
        super().__init__(np.asarray(values, dtype=float).reshape(-1, 1), [[0]], colour, lattice=lattice, **look)


class Camera:
    """Parallel projection. focus: the position (3) in the middle of the picture; toward: from the body to the reader (3); up (3);
    half_height: half the height of the picture, in the unit of positions; size: pixels (width, height)"""

    def __init__(self, focus, toward, up, half_height, size):
        self.focus, self.half_height, self.size = np.asarray(focus, dtype=float), float(half_height), tuple(int(n) for n in size)
        self.toward = np.asarray(toward) / np.linalg.norm(toward)
        right = np.cross(up, self.toward)
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(self.toward, self.right)

    def pixels(self, points):
        """(k, 2) columns and rows, from the top left, of positions (k, 3)."""
        arm = np.atleast_2d(points) - self.focus
        scale = 0.5 * self.size[1] / self.half_height
        return np.c_[0.5 * self.size[0] + scale * arm @ self.right, 0.5 * self.size[1] - scale * arm @ self.up]

    def as_json(self):
        return json.dumps({"focus": self.focus.tolist(), "position": (self.focus + 10.0 * self.half_height * self.toward).tolist(),
                           "up": self.up.tolist(), "half_height": self.half_height, "size": self.size})


def python_with_vtk():
    """An interpreter that has VTK, or None."""
    if importlib.util.find_spec("vtkmodules") is not None:
        return sys.executable
    if os.path.exists(SYSTEM_PYTHON) and os.path.realpath(SYSTEM_PYTHON) != os.path.realpath(sys.executable):
        found = subprocess.run([SYSTEM_PYTHON, "-c", "import vtkmodules, numpy"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return SYSTEM_PYTHON if found.returncode == 0 else None
    return None


class Display:
    """A virtual display while in use; without Xvfb the environment as it is, which newer VTK can draw in without any display."""

    def __enter__(self):
        self.server, self.environment = None, dict(os.environ)
        program = shutil.which("Xvfb")
        if program is None:
            return self.environment
        read, write = os.pipe()
        options = ["-screen", "0", "640x480x24", "-nolisten", "tcp", "-noreset"]  # a reset would refuse those who connect again at once
        self.server = subprocess.Popen([program, "-displayfd", str(write), *options], pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()  # empty where the server has ended
        if number:
            self.environment["DISPLAY"] = f":{number}"
        return self.environment

    def __exit__(self, *_):
        if self.server is not None:
            self.server.terminate()
            self.server.wait()


class Window:
    """One VTK process on one display, that draws pictures one after another; each costs no start of either. It draws while its user does other
    things: send pictures as early as their pieces are known, and receive them late. Use it in a with statement."""

    def __enter__(self):
        self.python, self.child, self.number, self.received = python_with_vtk(), None, 0, 0
        if self.python is not None:
            self.display, self.folder = Display(), tempfile.TemporaryDirectory(prefix="rhegma-picture-")
            environment = self.display.__enter__()
            try:
                self.child = subprocess.Popen([self.python, CHILD], env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                              stderr=subprocess.DEVNULL, universal_newlines=True)
            except OSError:
                self.child = None  # it draws nothing
        return self

    def __exit__(self, *_):
        if self.python is None:
            return
        if self.child is not None:
            if self.received < self.number:
                self.child.kill()  # nobody waits for its pictures
            for end in (self.child.stdin, self.child.stdout):
                try:
                    end.close()  # the process ends with what it reads
                except OSError:
                    pass
            try:
                self.child.wait(timeout=10)
            except subprocess.TimeoutExpired:
                self.child.kill()
                self.child.wait()
        self.display.__exit__()
        self.folder.cleanup()

    def file(self, number, ending):
        return os.path.join(self.folder.name, f"{number}.{ending}")

    def send(self, pieces, camera):
        """Lets a picture of pieces be drawn; receive it in the order in which it was sent."""
        if self.child is None:
            return
        self.number += 1
        shown = [piece for piece in pieces if len(piece.cells)]
        arrays = {f"{name}{i}": getattr(piece, name) for i, piece in enumerate(shown) for name in ("points", "cells", "colours")}
        np.savez(self.file(self.number, "npz"), camera=camera.as_json(), looks=json.dumps([piece.look for piece in shown]), **arrays)
        try:
            self.child.stdin.write(json.dumps([self.file(self.number, "npz"), self.file(self.number, "npy")]) + "\n")
            self.child.stdin.flush()
        except OSError:
            pass  # VTK has ended the process, as it does without a display

    def receive(self):
        """The next picture (rows, columns, 3) that was sent, or None where there is no VTK or no display."""
        if self.child is None:
            return None
        self.received += 1
        target = self.file(self.received, "npy")
        late = threading.Timer(LONGEST, self.child.kill)
        late.start()
        try:
            drawn = self.child.stdout.readline()  # empty where VTK has ended the process
        except OSError:
            drawn = ""
        finally:
            late.cancel()
        if not drawn or not os.path.exists(target):
            return None
        image = np.load(target)
        os.remove(self.file(self.received, "npz"))
        os.remove(target)
        return image

    def render(self, pieces, camera):
        """A picture (rows, columns, 3) of pieces, or None where there is no VTK or no display."""
        self.send(pieces, camera)
        return self.receive()


def render(pieces, camera):
    """One picture (rows, columns, 3) of pieces, or None where there is no VTK or no display."""
    with Window() as window:
        return window.render(pieces, camera)
