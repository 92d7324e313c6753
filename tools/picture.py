"""Renders one frame of an Exodus result: deformed shape, mesh edges, one nodal field in colour, or the side sets of a mesh.

Run by tools/picture under pvpython."""

import argparse
import os
import sys

import numpy
import paraview.simple
from paraview import servermanager
from paraview.simple import *  # noqa: F401,F403  (ParaView's own idiom)
from vtkmodules.numpy_interface import dataset_adapter

# Pixels: width of a picture, what it keeps clear at the sides, above for the time, below for the colour bar; size of the letters.
WIDTH, MARGIN, HEAD, FOOT, FONT = 1600, 50, 60, 170, 26
# Colours that those who see few colours tell apart too (Okabe and Ito), lightened.
SIDE_COLOURS = [[0.95, 0.75, 0.35], [0.55, 0.80, 0.95], [0.45, 0.80, 0.65], [0.97, 0.93, 0.55], [0.90, 0.60, 0.45], [0.85, 0.68, 0.80],
                [0.50, 0.62, 0.90], [0.70, 0.70, 0.70]]


def arguments():
    parser = argparse.ArgumentParser(prog="tools/picture", description=__doc__)
    parser.add_argument("results", metavar="RESULTS.e")
    parser.add_argument("-o", dest="out", metavar="OUT.png", required=True)
    parser.add_argument("--time", type=float, help="the frame nearest to this time; default: the last")
    parser.add_argument("--field", help="a nodal field; default: von_mises, else the first one there is")
    parser.add_argument("--range", metavar="LOW,HIGH", help="of the colours; default: all values of the frame")
    parser.add_argument("--sides", action="store_true", help="the side sets, each in a colour of its own with its name")
    parser.add_argument("--cut", metavar="x,y,z", help="with --sides: leave out the elements on this side of the middle")
    parser.add_argument("--width", type=int, default=WIDTH, help=f"of the picture in pixels, default: {WIDTH}")
    parser.add_argument("--view", action="append", metavar="x,y,z",
                        help="from the scene to the eye, default: -0.45,-1,0.6; a further --view makes a further picture OUT_2.png")
    # A view starts with a minus sign as often as not: argparse wants it joined to its option.
    words, joined = sys.argv[1:], []
    while words:
        word = words.pop(0)
        joined.append(word + "=" + words.pop(0) if word in ("--view", "--time", "--range", "--cut") and words else word)
    options = parser.parse_args(joined)
    if not os.path.isfile(options.results):
        parser.error(f"no such file: {options.results}")
    try:
        options.view = [[float(c) for c in view.split(",")] for view in options.view or ["-0.45,-1,0.6"]]
        options.cut = [float(c) for c in options.cut.split(",")] if options.cut else None
        if any(len(view) != 3 or not any(view) for view in options.view + ([options.cut] if options.cut else [])):
            raise ValueError
    except ValueError:
        parser.error("--view and --cut take three numbers, not all zero, separated by commas")
    try:
        options.range = [float(c) for c in options.range.split(",")] if options.range else None
        if options.range and not (len(options.range) == 2 and options.range[0] < options.range[1]):
            raise ValueError
    except ValueError:
        parser.error("--range takes two ascending numbers, separated by a comma")
    return options


def open_results(file):
    """The reader, with every nodal field on and the displacement applied."""
    reader = ExodusIIReader(FileName=[os.path.abspath(file)])
    reader.UpdatePipelineInformation()
    reader.PointVariables = reader.PointVariables.Available
    reader.ApplyDisplacements = 1
    reader.GenerateObjectIdCellArray = 0
    reader.GenerateGlobalElementIdArray = 0
    reader.GenerateGlobalNodeIdArray = 0
    return reader


def nearest_frame(reader, time):
    frames = list(reader.TimestepValues) if reader.TimestepValues else [0.0]
    return frames[-1] if time is None else min(frames, key=lambda t: abs(t - time))


def choose_field(reader, wanted):
    """Name of the array to colour by, or None for a file with a mesh alone."""
    # ParaView joins displacement_x, _y, _z to the vector "displacement_".
    names = {name.rstrip("_"): name for name in reader.PointData.keys() if not name.startswith(("Global", "Pedigree", "Object"))}
    if wanted is None:
        return names.get("von_mises") or next(iter(names.values()), None)
    field = names.get(wanted.strip().replace(" ", "_").rstrip("_")) or names.get(wanted)
    if field is None:
        sys.exit(f"tools/picture: no nodal field {wanted}; the file has: {', '.join(sorted(names)) or 'none'}")
    return field


def shown_points(reader):
    """Positions of all nodes as drawn, n x 3."""
    blocks = dataset_adapter.WrapDataObject(servermanager.Fetch(reader)).Points
    return numpy.vstack([numpy.asarray(block) for block in getattr(blocks, "Arrays", [blocks])])


def show_sides(file, reader, view, cut, font):
    """Each side set in a colour of its own. Returns their names as texts in these colours, to be placed, and what a cut lays open."""
    def show(source, rgb):
        display = Show(cut_open(source, reader, cut) if cut else source, view)
        style(display)
        display.Ambient, display.Diffuse = 0.5, 0.5
        display.ColorArrayName = ["POINTS", ""]
        display.DiffuseColor = display.AmbientColor = rgb
        return display

    inside = show(reader, [0.85, 0.85, 0.85]) if cut else None
    labels = []
    for number, name in enumerate(reader.GetProperty("SideSetArrayStatus").Available):
        rgb = SIDE_COLOURS[number % len(SIDE_COLOURS)]
        sides = ExodusIIReader(FileName=[os.path.abspath(file)])
        sides.ElementBlocks = []
        sides.SideSetArrayStatus = [name]
        show(sides, rgb)
        label = Show(Text(Text=name.split(" ID:")[0]), view)
        label.Color = [0.7 * c for c in rgb]
        label.Bold = 1
        label.FontSize = font
        label.WindowLocation = "Any Location"
        labels.append(label)
    return labels, inside


def cut_open(source, reader, normal):
    """What lies behind the plane through the middle of the mesh, in whole elements."""
    half = Clip(Input=source, Crinkleclip=1)
    half.ClipType = "Plane"
    low_high = reader.GetDataInformation().GetBounds()
    half.ClipType.Origin = [0.5 * (low_high[2 * i] + low_high[2 * i + 1]) for i in range(3)]
    half.ClipType.Normal = normal
    return half


def style(display):
    display.Representation = "Surface With Edges"
    display.EdgeColor = [0.45, 0.45, 0.45]
    display.LineWidth = 1.0
    display.Ambient, display.Diffuse, display.Specular = 0.35, 0.7, 0.0


def place_camera(view, points, eye):
    """Parallel projection that just holds the points; returns the height of the picture that this needs."""
    toward_eye = numpy.array(eye) / numpy.linalg.norm(eye)
    right = numpy.cross([0, 0, 1] if abs(toward_eye[2]) < 0.99 else [0, 1, 0], toward_eye)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(toward_eye, right)
    axes = numpy.array([right, up, toward_eye])
    low, high = (points @ axes.T).min(axis=0), (points @ axes.T).max(axis=0)
    wide, tall, deep = numpy.maximum(high - low, 1e-9 * max(high - low))

    scene = min(max((WIDTH - 2 * MARGIN) * tall / wide, 400), 1000)  # pixels
    height = int(HEAD + scene + FOOT)
    per_pixel = max(tall / scene, wide / (WIDTH - 2 * MARGIN))
    focus = 0.5 * (low + high)
    focus[1] -= 0.5 * (FOOT - HEAD) * per_pixel
    view.ViewSize = [WIDTH, height]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = list(focus @ axes)
    view.CameraPosition = list((focus + [0, 0, 2 * (deep + wide + tall)]) @ axes)
    view.CameraViewUp = list(up)
    view.CameraParallelScale = 0.5 * height * per_pixel
    return height


def colour(display, reader, field, view, chosen):
    ColorBy(display, ("POINTS", field, "Magnitude") if reader.PointData[field].GetNumberOfComponents() > 1 else ("POINTS", field))
    table = GetColorTransferFunction(field)
    table.ApplyPreset("Viridis (matplotlib)", True)
    components = reader.PointData[field].GetNumberOfComponents()
    low, high = reader.PointData[field].GetRange(-1 if components > 1 else 0)
    if 0 < low < 0.05 * high:
        low = 0.0
    if high - low <= 1e-12 * max(abs(low), abs(high)):  # a constant: a range that shows it as one
        low, high = low - 0.5 * (abs(low) or 1.0), high + 0.5 * (abs(high) or 1.0)
    if chosen:
        low, high = chosen
    table.RescaleTransferFunction(low, high)
    bar = GetScalarBar(table, view)
    bar.Title = field.rstrip("_").replace("_", " ").replace("von mises", "von Mises stress")
    bar.ComponentTitle = "magnitude" if components > 1 else ""
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.Position = [0.3, 0.03]
    bar.ScalarBarLength = 0.4
    bar.ScalarBarThickness = 22
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.TitleFontSize = bar.LabelFontSize = FONT
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = "%.3g"
    bar.Visibility = 1


def main():
    options = arguments()
    reader = open_results(options.results)
    time = nearest_frame(reader, options.time)
    reader.UpdatePipeline(time)
    field = choose_field(reader, options.field)

    paraview.simple._DisableFirstRenderCameraReset()  # the camera is placed below
    view = CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]
    view.ViewTime = time
    side_labels, inside = [], None
    if options.sides:
        side_labels, inside = show_sides(options.results, reader, view, options.cut, round(2 * FONT * options.width / WIDTH))
    else:
        display = Show(reader, view)
        style(display)
        if field:
            colour(display, reader, field, view, options.range)
        else:
            display.ColorArrayName = ["POINTS", ""]
            display.DiffuseColor = display.AmbientColor = [0.75, 0.8, 0.85]
    if reader.TimestepValues:  # a mesh alone has none
        label = Text(Text=f"t = {time:.4g}")
        label_display = Show(label, view)
        label_display.Color = [0.0, 0.0, 0.0]
        label_display.FontSize = FONT
        label_display.WindowLocation = "Upper Left Corner"

    points = shown_points(reader)
    stem, ending = os.path.splitext(options.out)
    for number, eye in enumerate(options.view, 1):
        out = options.out if number == 1 else f"{stem}_{number}{ending or '.png'}"
        height = place_camera(view, points, eye)
        if inside:  # away from the eye, which a parallel projection does not show: so that the sides lie before it
            inside.Position = list(-0.01 * numpy.ptp(points) * numpy.array(eye) / numpy.linalg.norm(eye))
        for k, label in enumerate(side_labels):  # below the mesh, in two rows
            across, left, apart = (3, 0.2, 0.25) if len(side_labels) <= 6 else (4, 0.15, 0.215)
            label.Position = [left + apart * (k % across), (FOOT - 80 * (1 + k // across)) / height]
        Render(view)
        SaveScreenshot(out, view, ImageResolution=[options.width, round(options.width * height / WIDTH)], TransparentBackground=0)
        print(f"picture: {os.path.abspath(out)}")


main()
