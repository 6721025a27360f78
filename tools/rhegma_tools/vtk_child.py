"""Draws the pieces of files by VTK, off screen. Started by vtk_window.py: VTK ends its process where it finds no display."""

import json
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkTubeFilter
from vtkmodules.vtkFiltersHybrid import vtkPolyDataSilhouette
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (the back end registers itself)

OUTLINE = (0.54, 0.58, 0.61)  # of surfaces that one sees through


def poly_data(points, cells, colours, lines):
    """Polygons or lines (k, corners) with a colour (k, 3) of each."""
    data, vertices, array = vtkPolyData(), vtkPoints(), vtkCellArray()
    vertices.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    data.SetPoints(vertices)
    counted = np.hstack([np.full((len(cells), 1), cells.shape[1]), cells]).astype(np.int64)
    array.SetCells(len(cells), numpy_to_vtkIdTypeArray(np.ascontiguousarray(counted.ravel()), deep=True))
    (data.SetLines if lines else data.SetPolys)(array)
    data.GetCellData().SetScalars(numpy_to_vtk(np.ascontiguousarray(colours, dtype=np.uint8), deep=True))
    return data


def level_surface(values, lattice):
    """Where a field on a lattice has a value, with the normals of its gradient."""
    image = vtkImageData()
    image.SetDimensions(*lattice["shape"])
    image.SetOrigin(*lattice["origin"])
    image.SetSpacing(*3 * [lattice["spacing"]])
    ordered = values.reshape(lattice["shape"]).transpose(2, 1, 0).ravel()  # x first
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(ordered), deep=True))
    surface = vtkFlyingEdges3D()
    surface.SetInputData(image)
    surface.SetValue(0, lattice["level"])
    surface.ComputeNormalsOn()
    surface.ComputeScalarsOff()
    return surface


def side_of(mapper, colour, opacity, far):
    """The far or the near side of a closed surface. The far one is drawn first, so that what is translucent has no speckles of wrong order."""
    result = vtkActor()
    result.SetMapper(mapper)
    look = result.GetProperty()
    look.SetColor(*(float(part) / 255.0 for part in colour))
    look.SetOpacity(opacity)
    look.SetAmbient(0.35)
    look.SetDiffuse(0.65)
    look.SetInterpolationToPhong()
    look.SetFrontfaceCulling(far)
    look.SetBackfaceCulling(not far)
    return result


def silhouette(surface, camera):
    """Where a surface turns away from the reader, as lines."""
    edges = vtkPolyDataSilhouette()
    edges.SetInputConnection(surface.GetOutputPort())
    edges.SetCamera(camera)
    edges.SetEnableFeatureAngle(0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(edges.GetOutputPort())
    mapper.ScalarVisibilityOff()
    result = vtkActor()
    result.SetMapper(mapper)
    look = result.GetProperty()
    look.SetColor(*OUTLINE)
    look.SetLineWidth(1.5)
    look.LightingOff()
    return result


def actors(points, cells, colours, look, camera):
    """camera: of the view; look: lines, tube (radius), opacity, width (pixels), flat (without light), lattice (of a field, whose values are in points)"""
    if look.get("lattice"):
        mapper, surface = vtkPolyDataMapper(), level_surface(points, look["lattice"])
        mapper.SetInputConnection(surface.GetOutputPort())
        mapper.ScalarVisibilityOff()
        return [*(side_of(mapper, colours[0], look.get("opacity", 1.0), far) for far in (True, False)), silhouette(surface, camera)]
    data = poly_data(points, cells, colours, look.get("lines"))
    mapper = vtkPolyDataMapper()
    if look.get("tube"):
        tube = vtkTubeFilter()
        tube.SetInputData(data)
        tube.SetRadius(look["tube"])
        tube.SetNumberOfSides(16)
        tube.CappingOn()
        mapper.SetInputConnection(tube.GetOutputPort())
    else:
        mapper.SetInputData(data)
    mapper.SetScalarModeToUseCellData()
    result = vtkActor()
    result.SetMapper(mapper)
    result.GetProperty().SetOpacity(look.get("opacity", 1.0))
    result.GetProperty().SetLineWidth(look.get("width", 1.0))
    result.GetProperty().SetAmbient(1.0 if look.get("flat") else 0.6)
    result.GetProperty().SetDiffuse(0.0 if look.get("flat") else 0.45)
    result.GetProperty().SetInterpolationToFlat()
    return [result]


class Window:
    """An off-screen window for pictures of pieces."""

    def __init__(self):
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(8)
        self.window.SetAlphaBitPlanes(1)
        self.window.AddRenderer(self.renderer)

    def show(self, found):
        """found: looks and camera as JSON and the arrays of each piece"""
        camera = json.loads(str(found["camera"]))
        self.renderer.RemoveAllViewProps()
        self.window.SetSize(*camera["size"])
        view = self.renderer.GetActiveCamera()
        view.ParallelProjectionOn()
        view.SetFocalPoint(*camera["focus"])
        view.SetPosition(*camera["position"])
        view.SetViewUp(*camera["up"])
        view.SetParallelScale(camera["half_height"])
        for i, look in enumerate(json.loads(str(found["looks"]))):
            for one in actors(found[f"points{i}"], found[f"cells{i}"], found[f"colours{i}"], look, view):
                self.renderer.AddActor(one)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()

    def pixels(self):
        """What is shown (rows, columns, 3), from the top."""
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        image = grab.GetOutput()
        columns, rows, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[::-1, :, :3]


def main(lines, answers):
    """lines: of an npz to read and an npy to write, as JSON; a line is answered once its picture is written"""
    window = Window()
    for line in lines:
        source, target = json.loads(line)
        with np.load(source) as found:
            window.show(found)
        np.save(target, window.pixels())
        print("drawn", file=answers, flush=True)


if __name__ == "__main__":
    main(sys.stdin, sys.stdout)
