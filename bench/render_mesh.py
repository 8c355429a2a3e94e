#!/usr/bin/env python3
"""Draws a mesh cut open, coloured by sub-domain: bench/render_mesh.py MESH.vtkhdf PICTURE.png

Needs VTK's Python module (Debian: python3-vtk9, /usr/bin/python3) and a display (xvfb-run will do).
Whole tets are shown on the far side of the plane y = AT, and the boundary patches that are named.
"""

import argparse

import vtk


def threshold(source, array, low, high):
    result = vtk.vtkThreshold()
    result.SetInputConnection(source.GetOutputPort())
    result.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, array)
    result.SetLowerThreshold(low)
    result.SetUpperThreshold(high)
    result.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_BETWEEN)
    return result


def surface_actor(source, edge_width):
    surface = vtk.vtkGeometryFilter()
    surface.SetInputConnection(source.GetOutputPort())
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetEdgeVisibility(True)
    actor.GetProperty().SetEdgeColor(0.15, 0.15, 0.2)
    actor.GetProperty().SetLineWidth(edge_width)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.7)
    return actor, mapper


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("picture")
    parser.add_argument("--at", type=float, default=0.0, help="y of the cut")
    parser.add_argument("--patches", type=int, nargs=2, default=[0, 0], metavar=("FIRST", "LAST"))
    parser.add_argument("--focus", type=float, nargs=3, required=True)
    parser.add_argument("--eye", type=float, nargs=3, required=True)
    parser.add_argument("--angle", type=float, default=30, help="of view, degrees")
    options = parser.parse_args()

    reader = vtk.vtkHDFReader()
    reader.SetFileName(options.mesh)
    tets = threshold(reader, "patch", -1, -1)
    plane = vtk.vtkPlane()
    plane.SetOrigin(0, options.at, 0)
    plane.SetNormal(0, 1, 0)
    cut = vtk.vtkExtractGeometry()
    cut.SetInputConnection(tets.GetOutputPort())
    cut.SetImplicitFunction(plane)
    cut.SetExtractInside(False)
    cut.SetExtractBoundaryCells(True)
    volume, mapper = surface_actor(cut, 0.6)
    cut.Update()
    high = max(1, cut.GetOutput().GetCellData().GetArray("subdomain").GetRange()[1])
    colours = vtk.vtkLookupTable()
    colours.SetNumberOfTableValues(int(high) + 1)
    palette = [(0.55, 0.75, 0.90), (0.98, 0.80, 0.55), (0.70, 0.87, 0.60), (0.90, 0.65, 0.65),
               (0.78, 0.72, 0.90), (0.95, 0.93, 0.60), (0.65, 0.88, 0.85), (0.92, 0.75, 0.85)]
    for i in range(int(high) + 1):
        colours.SetTableValue(i, *palette[i % len(palette)], 1)
    mapper.SetLookupTable(colours)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("subdomain")
    mapper.SetScalarRange(0, high)
    body, body_mapper = surface_actor(threshold(reader, "patch", *options.patches), 0.3)
    body_mapper.ScalarVisibilityOff()
    body.GetProperty().SetColor(0.75, 0.77, 0.80)

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(volume)
    renderer.AddActor(body)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*options.focus)
    camera.SetPosition(*options.eye)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(options.angle)
    renderer.ResetCameraClippingRange()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(1400, 800)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(options.picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
