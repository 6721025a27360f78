"""Images of voxels: pictures and stacks of pictures as NumPy arrays with the axes x, y (upwards) and z, and their outlines."""

import os
import re

import numpy as np

from rhegma.problem import Problem

from .output_file import replacing

PILLOW = "Pillow is not installed; it reads pictures. Install it, on Debian or Ubuntu with apt-get install python3-pil."
MOST = 20000  # edges of an outline; of more only the bounds are drawn


def grey_values(picture, name):
    """Integers (rows, columns) of one picture of Pillow."""
    if picture.mode == "P":
        raise Problem(f"{name} has a palette of colours; save it in shades of grey.")
    values = np.asarray(picture)
    if values.dtype == bool:
        values = values.astype(np.uint8)
    if values.ndim == 3:
        colours = values[:, :, :3] if values.shape[2] >= 3 else values[:, :, :1]
        opaque = values.shape[2] in (1, 3) or bool(np.all(values[:, :, -1] == values[0, 0, -1]))
        if not opaque or np.any(colours != colours[:, :, :1]):
            raise Problem(f"{name} is in colour; each material needs a grey value: save the picture in shades of grey.")
        values = colours[:, :, 0]
    if not np.issubdtype(values.dtype, np.integer):
        raise Problem(f"{name} has grey values that are no integers; save it with 8 or 16 bits per pixel.")
    return values


def bits_of(picture):
    """Bits of a grey value of a picture of Pillow: 1, 8, or 16 (and more)."""
    return 1 if picture.mode == "1" else 16 if picture.mode.startswith("I") else 8


def refuse_lossy(picture, name):
    """JPEG changes grey values around edges, so that voxels of one material no longer have one value."""
    if picture.format == "JPEG" or "jpeg" in str(picture.info.get("compression", "")).lower():
        raise Problem(f"{name} is compressed by JPEG, which changes grey values at the edges of materials; save it without loss, as PNG or as TIFF with LZW.")


def read_pictures(paths):
    """Array (x, y) of one picture, or (x, y, z) of a file with several pages or of several files in their order: z = 0 is the first."""
    try:
        from PIL import Image, ImageSequence, UnidentifiedImageError
    except ImportError:
        raise Problem(PILLOW)
    Image.MAX_IMAGE_PIXELS = None
    layers, bits = [], []
    for path in paths:
        if not os.path.isfile(path):
            raise Problem(f"there is no file {path}; give pictures, such as PNG or TIFF files.")
        try:
            with Image.open(path) as image:
                for page in ImageSequence.Iterator(image):
                    refuse_lossy(page, path)
                    layers.append(grey_values(page, path))
                    bits.append(bits_of(page))
                    if bits[-1] != bits[0]:
                        raise Problem(f"{path}{f', page {page.tell() + 1}' if len(paths) == 1 else ''} has {bits[-1]} bits per pixel and the first picture "
                                      f"{bits[0]}, so that one grey value means two things; save all pictures of a stack with as many bits.")
        except (UnidentifiedImageError, OSError) as error:
            raise Problem(f"{path} can't be read as a picture ({error}).")
    for path, layer in zip(paths if len(paths) == len(layers) else [paths[0]] * len(layers), layers):
        if layer.shape != layers[0].shape:
            raise Problem(f"{path} has {layer.shape[1]} x {layer.shape[0]} pixels and the first picture {layers[0].shape[1]} x {layers[0].shape[0]}; "
                          "all pictures of a stack must have one size.")
    upright = [layer[::-1].T for layer in layers]  # rows of a picture go down
    return np.ascontiguousarray(upright[0] if len(upright) == 1 else np.stack(upright, axis=2))


def pictures_of(path):
    """The files of a picture or of a folder of pictures, in the order of their names, in which numbers count as numbers."""
    if not os.path.isdir(path):
        return [path]
    names = [name for name in os.listdir(path) if name.lower().endswith((".png", ".tif", ".tiff"))]
    return [os.path.join(path, name) for name in sorted(names, key=lambda name: [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)])]


def by_thresholds(image, thresholds):
    """0 below the first threshold, 1 from there to the second, and so on."""
    return np.searchsorted(np.sort(thresholds), image, side="right").astype(np.uint8)


def write_voxels(image, path, pictures=()):
    """Replaces a .npy file. pictures: paths of what the image was read from"""
    with replacing(path, pictures) as temporary, open(temporary, "wb") as file:
        np.save(file, image)


def counts_text(image):
    """Values and how many voxels have each: "0 (1200), 255 (800)"."""
    values, counts = np.unique(image, return_counts=True)
    text = ", ".join(f"{value} ({count})" for value, count in list(zip(values, counts))[:12])
    return text + (f" and {len(values) - 12} more" if len(values) > 12 else "")


def runs(marks):
    """(starts, ends) of the runs of True of a row."""
    change = np.flatnonzero(np.diff(np.r_[False, marks, False].astype(np.int8)))
    return change[::2], change[1::2]


def phase_lines(image, value):
    """Lines (2, 3), in voxels, around the voxels of a value: in 2D edges between them and others, in 3D the edges of their bounds."""
    inside = np.pad(image == value, 1)
    if not inside.any():
        return []
    lines = []
    if inside.ndim == 2:
        for axis in (0, 1):
            border = np.diff(inside.astype(np.int8), axis=axis) != 0  # (axis 0) along y between columns
            for at, marks in enumerate(border if axis == 0 else border.T):
                for start, end in zip(*runs(marks)):
                    ends = np.array([[at, start - 1, 0.0], [at, end - 1, 0.0]])
                    lines.append(ends if axis == 0 else ends[:, [1, 0, 2]])
        if len(lines) <= MOST:
            return lines
    held = np.argwhere(inside)
    low, high = np.zeros(3), np.zeros(3)
    low[:inside.ndim], high[:inside.ndim] = held.min(axis=0) - 1, held.max(axis=0)
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in ((0, 1) if inside.ndim == 3 else (0,))])
    points = low + corners * (high - low)
    return [np.array([points[i], points[j]]) for i in range(len(points)) for j in range(i) if np.abs(corners[i] - corners[j]).sum() == 1]


def voxel_lines(path, value):
    """(lines of a phase, number of voxels along each axis (3)), in voxels; none where the file can't be read, of which the program says why."""
    try:
        image = np.load(path, mmap_mode="r", allow_pickle=False) if path.endswith(".npy") else read_pictures(pictures_of(path))
        count = np.zeros(3)
        count[:image.ndim] = image.shape
        return (phase_lines(image, value) if image.ndim in (2, 3) else []), count
    except (OSError, ValueError, Problem):
        return [], np.zeros(3)
