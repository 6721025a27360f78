"""Reads an XDMF file with a reader of VTK and prints what it found as JSON: readFields.py READER FILE

READER is vtkXdmfReader or vtkXdmf3Reader. With no arguments its exit status says whether both exist.
"""

import json
import sys

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
from vtkmodules.vtkIOXdmf3 import vtkXdmf3Reader


def arrays(data):
    found = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        found[data.GetArrayName(i)] = [list(array.GetTuple(t)) for t in range(array.GetNumberOfTuples())]
    return found


def mesh(block):
    cells = []
    for c in range(block.GetNumberOfCells()):
        points = block.GetCell(c).GetPointIds()
        cells.append([points.GetId(k) for k in range(points.GetNumberOfIds())])
    return {
        "points": [list(block.GetPoint(i)) for i in range(block.GetNumberOfPoints())],
        "cells": cells,
        "types": sorted({block.GetCellType(c) for c in range(block.GetNumberOfCells())}),
        "on points": arrays(block.GetPointData()),
        "on cells": arrays(block.GetCellData()),
    }


def read(reader, path):
    reader.SetFileName(path)
    reader.UpdateInformation()
    information = reader.GetOutputInformation(0)
    times = [information.Get(Pipeline.TIME_STEPS(), i) for i in range(information.Length(Pipeline.TIME_STEPS()))]
    found = []
    for time in times:
        reader.UpdateTimeStep(time)
        blocks = reader.GetOutputDataObject(0)
        found.append({"time": time, "meshes": [mesh(blocks.GetBlock(i)) for i in range(blocks.GetNumberOfBlocks())]})
    return found


if len(sys.argv) == 3:
    kind = {"vtkXdmfReader": vtkXdmfReader, "vtkXdmf3Reader": vtkXdmf3Reader}[sys.argv[1]]
    print(json.dumps(read(kind(), sys.argv[2])))
