#!/usr/bin/python3
"""Reads a mesh with a library that is not ours and prints what it found as JSON.

read_counts.py vtk|meshio|meshio-places FILE; the last counts nodes by place. Needs Debian's python3-vtk9 and python3-meshio, so it runs with the
system's Python.
"""

import json
import sys

import numpy


def volume_of(points, tets):
    a, b, c, d = (points[tets[:, i]] for i in range(4))
    return float(numpy.einsum("ij,ij->i", numpy.cross(b - a, c - a), d - a).sum() / 6)


def from_meshio(name):
    import meshio

    mesh = meshio.read(name)
    tets = [block.data for block in mesh.cells if block.type == "tetra"]
    triangles = sum(len(block.data) for block in mesh.cells if block.type == "triangle")
    tets = numpy.concatenate(tets).astype(numpy.int64)
    return {"nodes": len(mesh.points), "tets": len(tets), "triangles": triangles,
            "volume": volume_of(mesh.points, tets)}


def from_meshio_by_places(name):
    import meshio

    return {**from_meshio(name), "nodes": len(numpy.unique(meshio.read(name).points, axis=0))}


def from_vtk(name):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    readers = {"vtkhdf": vtk.vtkHDFReader, "pvtu": vtk.vtkXMLPUnstructuredGridReader,
               "cgns": vtk.vtkCGNSReader}
    reader = readers[name.rsplit(".", 1)[-1]]()
    reader.SetFileName(name)
    if name.endswith(".cgns"):
        reader.UpdateInformation()
        reader.EnableAllBases()
        reader.SetLoadBndPatch(True)
    reader.Update()
    data = reader.GetOutputDataObject(0)
    grids = []

    def collect(node):
        if node is None:
            return
        if node.IsA("vtkMultiBlockDataSet"):
            for i in range(node.GetNumberOfBlocks()):
                collect(node.GetBlock(i))
        else:
            grids.append(node)

    collect(data)
    nodes, counts, volume = 0, {5: 0, 10: 0}, 0.0
    numbers = set()
    for grid in grids:
        points = vtk_to_numpy(grid.GetPoints().GetData())
        types = vtk_to_numpy(grid.GetCellTypesArray())
        for kind in counts:
            counts[kind] += int((types == kind).sum())
        if not (types == 10).any():
            continue
        nodes += len(points)
        cells = grid.GetCells()
        offsets = vtk_to_numpy(cells.GetOffsetsArray())
        connectivity = vtk_to_numpy(cells.GetConnectivityArray())
        tets = connectivity[offsets[:-1][types == 10][:, None] + numpy.arange(4)]
        volume += volume_of(points, tets)
        ids = grid.GetPointData().GetArray("GlobalNodeId")
        if ids is not None:
            numbers.update(vtk_to_numpy(ids).tolist())
    return {"nodes": len(numbers) or nodes, "tets": counts[10], "triangles": counts[5],
            "volume": volume}


if __name__ == "__main__":
    libraries = {"vtk": from_vtk, "meshio": from_meshio, "meshio-places": from_meshio_by_places}
    print(json.dumps(libraries[sys.argv[1]](sys.argv[2])))
