#!/usr/bin/python3
"""Reads a mesh with a library that is not ours and prints what it found as JSON.

read_counts.py vtk|meshio|meshio-places|vtk-mixed|meshio-mixed|meshio-mixed-places FILE; "mixed" knows all types of cells,
"places" counts nodes by place. Needs Debian's python3-vtk9 and python3-meshio, so it runs with the
system's Python.
"""

import json
import sys

import numpy


def volume_of(points, tets):
    a, b, c, d = (points[tets[:, i]] for i in range(4))
    return float(numpy.einsum("ij,ij->i", numpy.cross(b - a, c - a), d - a).sum() / 6)


# The faces of meshio's types of cells, outwards: its nodes are in the order of Gmsh.
FACES = {"tetra": ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)),
         "pyramid": ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
         "wedge": ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
         "hexahedron": ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))}
NAMES = {"tetra": "tets", "pyramid": "pyramids", "wedge": "prisms", "hexahedron": "hexes",
         "triangle": "triangles", "quad": "quads"}


def mixed_from_meshio(name):
    """Counts of all types, and the volume that their faces enclose."""
    import meshio

    mesh = meshio.read(name)
    found = {"nodes": len(mesh.points), "volume": 0.0}
    for block in mesh.cells:
        if block.type not in NAMES:
            continue
        found[NAMES[block.type]] = found.get(NAMES[block.type], 0) + len(block.data)
        cells = block.data.astype(numpy.int64)
        for face in FACES.get(block.type, ()):
            for i in range(1, len(face) - 1):
                fan = numpy.column_stack([numpy.zeros(len(cells), int)] * 4)
                fan[:, 0] = cells[:, 0]
                for k, corner in enumerate((0, i, i + 1)):
                    fan[:, k + 1] = cells[:, face[corner]]
                found["volume"] += volume_of(mesh.points, fan)
    return found


def mixed_from_vtk(name):
    """The same; the volume is that of vtkCellSizeFilter."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    found = {"volume": 0.0}
    numbers, nodes = set(), 0
    codes = {5: "triangles", 9: "quads", 10: "tets", 12: "hexes", 13: "prisms", 14: "pyramids"}
    for grid in grids_of(name):
        types = vtk_to_numpy(grid.GetCellTypesArray())
        for code, kind in codes.items():
            found[kind] = found.get(kind, 0) + int((types == code).sum())
        if not (types >= 10).any():
            continue
        nodes += grid.GetNumberOfPoints()
        ids = grid.GetPointData().GetArray("GlobalNodeId")
        if ids is not None:
            numbers.update(vtk_to_numpy(ids).tolist())
        sizes = vtk.vtkCellSizeFilter()
        sizes.SetInputData(grid)
        sizes.Update()
        found["volume"] += float(vtk_to_numpy(sizes.GetOutput().GetCellData().GetArray("Volume")).sum())
    return {**found, "nodes": len(numbers) or nodes}


def from_meshio(name):
    import meshio

    mesh = meshio.read(name)
    tets = [block.data for block in mesh.cells if block.type == "tetra"]
    triangles = sum(len(block.data) for block in mesh.cells if block.type == "triangle")
    tets = numpy.concatenate(tets).astype(numpy.int64)
    return {"nodes": len(mesh.points), "tets": len(tets), "triangles": triangles,
            "volume": volume_of(mesh.points, tets)}


def by_places(read):
    """What `read` finds, with the places of nodes counted instead of the nodes."""
    def counted(name):
        import meshio

        return {**read(name), "nodes": len(numpy.unique(meshio.read(name).points, axis=0))}
    return counted


def grids_of(name):
    import vtk

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
    return grids


def from_vtk(name):
    from vtk.util.numpy_support import vtk_to_numpy

    grids = grids_of(name)
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
    libraries = {"vtk": from_vtk, "meshio": from_meshio, "meshio-places": by_places(from_meshio),
                 "vtk-mixed": mixed_from_vtk, "meshio-mixed": mixed_from_meshio,
                 "meshio-mixed-places": by_places(mixed_from_meshio)}
    print(json.dumps(libraries[sys.argv[1]](sys.argv[2])))
