"""Opens the fields of a run in ParaView: the body coloured by stress, cut open in 3D, cracks, and fronts coloured by K or G.

In ParaView: File > Load State, or paraview --script=paraview_state.py. For a picture without a window: pvpython paraview_state.py picture.png."""

import json
import os
import sys

from paraview import simple

STATE = None


coloured = []  # displays with a range of colours


def path_of(name):
    """A file of the run: next to this script, else where it was when the script was written."""
    here = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else STATE["folder"]
    near = os.path.normpath(os.path.join(here, name))
    return near if os.path.exists(near) else os.path.normpath(os.path.join(STATE["folder"], name))


def read(label, file, grid):
    reader = simple.XDMFReader(registrationName=label, FileNames=[path_of(file)])
    reader.GridStatus = [name for name in reader.GridStatus if name.partition("[")[0] == grid]  # one for each time
    reader.UpdatePipeline()
    return reader


def show_bar(display, view, array, title):
    """Colours by an array of the points, with a bar. display: of a source"""
    simple.ColorBy(display, ("POINTS", array))
    display.RescaleTransferFunctionToDataRange(False, True)
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(array), view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleFontSize, bar.LabelFontSize, bar.ScalarBarLength = 14, 12, 0.3
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    display.SetScalarBarVisibility(view, True)
    coloured.append(display)
    return bar


def show_body(view):
    body = read("Body", STATE["fields"], "particles")
    if STATE["cut"]:
        body = simple.Clip(registrationName="Body cut open", Input=body, ClipType="Plane")
        body.ClipType.Origin, body.ClipType.Normal = STATE["cut"]["origin"], STATE["cut"]["normal"]
        body.Invert = 1  # keeps the side against the normal
    display = simple.Show(body, view)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Plain circle"
    display.ScaleByArray, display.SetScaleArray, display.UseScaleFunction = 1, ["POINTS", "edge"], 0
    display.GaussianRadius = 0.7  # edges: no gaps between particles
    names = {"von_mises": "von Mises stress [Pa]", "principal_stress": "largest principal stress [Pa]", "temperature": "temperature [K]"}
    bar = show_bar(display, view, STATE["stress"], names[STATE["stress"]])
    bar.WindowLocation = "Lower Right Corner"


def show_cracks(view):
    cracks = read("Cracks", STATE["fields"], "cracks")
    display = simple.Show(cracks, view)
    simple.ColorBy(display, None)
    display.SetRepresentationType("Surface With Edges" if STATE["surfaces"] else "Surface")
    display.AmbientColor = display.DiffuseColor = [0.75, 0.75, 0.78] if STATE["surfaces"] else [0.1, 0.1, 0.1]
    display.EdgeColor, display.LineWidth = [0.3, 0.3, 0.3], 1.0 if STATE["surfaces"] else 3.0


def show_fronts(view):
    known = STATE["fronts"]
    fronts = read("Fronts", known["file"], "fronts")
    if known["lines"]:
        fronts = simple.ExtractSurface(Input=fronts)
        fronts = simple.Tube(registrationName="Fronts as tubes", Input=fronts, Radius=0.3 * STATE["size"])
    display = simple.Show(fronts, view)
    if known["lines"]:
        display.SetRepresentationType("Surface")
    else:
        display.SetRepresentationType("Point Gaussian")
        display.ShaderPreset, display.GaussianRadius = "Sphere", 2.0 * STATE["size"]
    if known["quantity"] is None:
        return simple.ColorBy(display, None)
    simple.GetColorTransferFunction(known["quantity"]).ApplyPreset("Plasma (matplotlib)", True)
    bar = show_bar(display, view, known["quantity"], {"K_I": "K_I at fronts [Pa sqrt(m)]", "G": "G at fronts [J/m2]"}[known["quantity"]])
    bar.WindowLocation = "Upper Right Corner"


def main():
    view = simple.GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = [0.1, 0.1, 0.1]
    show_body(view)
    if STATE["cracks"]:
        show_cracks(view)
    if STATE["fronts"]:
        show_fronts(view)
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().GoToLast()
    simple.Render(view)
    for display in coloured:
        display.RescaleTransferFunctionToDataRange(False, True)
    camera = STATE["camera"]
    if camera:
        view.CameraParallelProjection = 1
        view.CameraFocalPoint, view.CameraViewUp = camera["focus"], camera["up"]
        view.CameraPosition = [f + t for f, t in zip(camera["focus"], camera["toward"])]
    else:
        view.InteractionMode = "2D"
    view.ResetCamera(False)
    simple.Render(view)
    if len(sys.argv) > 1 and sys.argv[1].endswith(".png"):
        view.ViewSize = [1200, 900]
        simple.SaveScreenshot(sys.argv[1], view, ImageResolution=[1200, 900])


main()
