"""Writes a state for ParaView of a run: the body coloured by stress, cut open in 3D, cracks, and fronts coloured by K or G."""

import json
import os
from xml.sax.saxutils import quoteattr

import numpy as np

from rhegma.fronts import read_series
from rhegma.history import read_history
from rhegma.problem import Problem

from .field_picture import choose_view
from .output_file import text_to
from .spatial_picture import camera_of

CHILD = os.path.join(os.path.dirname(os.path.realpath(__file__)), "paraview_child.py")
QUANTITIES = ("G", "K_I", "K_II", "K_III", "speed")
COLUMNS = {"G": "G_J"}  # of the history, where they have other names


class Frame:
    """Fronts at a time [s]. points (k, 3) [m]; lines: arrays of numbers of points; values: {quantity: (k)}"""

    def __init__(self, time, points, lines, values):
        self.time, self.points, self.lines, self.values = time, points, lines, values


def nearest(times, time):
    return int(np.argmin(np.abs(np.asarray(times) - time)))


def spatial_frame(series, time):
    """Fronts of a run in 3D at the sample nearest to a time."""
    points, lines, values, start = [], [], {name: [] for name in QUANTITIES}, 0
    for samples in series.values():
        sample = samples[nearest([one.time for one in samples], time)]
        for line in np.unique(sample.line):
            of = np.flatnonzero(sample.line == line)
            lines.append(start + of[np.argsort(sample.s[of], kind="stable")])
        start += len(sample.position)
        points.append(sample.position)
        for name in QUANTITIES:
            values[name].append(getattr(sample, name))
    return Frame(time, np.concatenate(points), lines, {name: np.concatenate(parts) for name, parts in values.items()})


def plane_frame(history, time):
    """Fronts of a run in 2D, which are points, at the sample nearest to a time; None where there are none yet."""
    at = nearest(history.time, time)
    points, values = [], {name: [] for name in QUANTITIES}
    for front in history.fronts:
        x, y = (history.of_front(front, name) for name in "xy")
        if x is None or y is None or not np.isfinite(x[at] + y[at]):
            continue
        points.append([x[at], y[at], 0.0])
        for name in QUANTITIES:
            column = history.of_front(front, COLUMNS.get(name, name))
            values[name].append(np.nan if column is None else column[at])
    if not points:
        return None
    return Frame(time, np.array(points), [], {name: np.array(found) for name, found in values.items() if np.any(np.isfinite(found))})


def data_item(values, kind="Float"):
    shape = " ".join(str(n) for n in np.shape(values))
    text = " ".join(repr(value) for value in np.ravel(values).tolist())
    return f'<DataItem Format="XML" Dimensions="{shape}" NumberType="{kind}" Precision="{8 if kind == "Float" else 4}">{text}</DataItem>'


def grid_of(frame):
    """A grid of XDMF with the fronts of a frame: lines, or points in 2D."""
    if frame.lines:
        cells = np.concatenate([np.r_[2, len(line), line] for line in frame.lines]).astype(int)  # 2: a polyline
        topology = f'<Topology TopologyType="Mixed" NumberOfElements="{len(frame.lines)}">{data_item(cells, "Int")}</Topology>'
    else:
        cells = np.arange(len(frame.points))
        topology = f'<Topology TopologyType="Polyvertex" NumberOfElements="{len(cells)}" NodesPerElement="1">{data_item(cells, "Int")}</Topology>'
    fields = [f'<Attribute Name={quoteattr(name)} AttributeType="Scalar" Center="Node">{data_item(values)}</Attribute>' for name, values in frame.values.items()]
    return "\n".join(['<Grid Name="fronts" GridType="Uniform">', f'<Time Value="{frame.time!r}"/>', topology,
                      f'<Geometry GeometryType="XYZ">{data_item(frame.points)}</Geometry>', *fields, "</Grid>"])


def fronts_of(folder, fields):
    """Frames of fronts, one for each frame of the fields."""
    series = read_series(folder) if fields.dimension == 3 else {}
    if series:
        return [spatial_frame(series, time) for time in fields.written]
    history = read_history(folder)
    if fields.dimension == 3 or history is None or len(history) == 0:
        return []
    return [frame for frame in (plane_frame(history, time) for time in fields.written) if frame is not None]


def replace(path, text):
    """Replaces a file by a text."""
    with text_to(path) as file:
        file.write(text)


def write_state(folder, fields, output, asked=None):
    """Writes paraview_state.py, and fronts.xdmf where there are fronts, into the folder `output`. asked: the slice. \\return paths written"""
    source = os.path.abspath(os.path.join(folder, "fields.xdmf"))
    if not os.path.exists(source):
        raise Problem(f"{folder} has no fields.xdmf; a run writes it unless Output > Fields says otherwise.")
    view = choose_view(fields, asked)
    camera, side = camera_of(fields, view, 1.0) if fields.dimension == 3 else (None, 1)
    frames = fronts_of(folder, fields)
    state = {
        "fields": os.path.relpath(source, os.path.abspath(output)),
        "folder": os.path.abspath(output),
        "stress": "principal_stress" if "principal_stress" in fields.names else "von_mises" if fields.stress is not None else "temperature",
        "cracks": fields.crack is not None,
        "surfaces": fields.crack is not None and fields.crack.is_surface,
        "size": float(np.median(np.linalg.norm(fields.edges[:, 0], axis=1))),
        "fronts": None,
        "cut": None,
        "camera": None,
    }
    written = []
    if frames:
        quantity = next((name for name in ("K_I", "G") if name in frames[-1].values and np.isfinite(frames[-1].values[name]).any()), None)
        state["fronts"] = {"file": "fronts.xdmf", "quantity": quantity, "lines": bool(frames[-1].lines)}
        collection = '<Grid Name="fronts" GridType="Collection" CollectionType="Temporal">'
        path = os.path.join(output, "fronts.xdmf")
        replace(path, "\n".join(['<?xml version="1.0"?>', '<Xdmf Version="3.0"><Domain>', collection, *map(grid_of, frames), "</Grid></Domain></Xdmf>", ""]))
        written.append(path)
    if camera is not None:
        beyond = view.where + side * 0.51 * state["size"]  # with the particles that the section cuts
        state["cut"] = {"normal": (np.eye(3)[view.normal] * side).tolist(), "origin": (np.eye(3)[view.normal] * beyond).tolist()}
        state["camera"] = {"focus": camera.focus.tolist(), "toward": camera.toward.tolist(), "up": camera.up.tolist()}
    with open(CHILD, encoding="utf-8") as file:
        script = file.read()
    path = os.path.join(output, "paraview_state.py")
    replace(path, script.replace("STATE = None", "STATE = json.loads(r'''" + json.dumps(state, indent=1).replace("'", "\\u0027") + "''')"))
    return [path, *written]
