#!/usr/bin/env python3
"""Layers of prisms by Gmsh on a closed surface of triangles: nodes, tets and prisms as a file of numpy, for bench/layers.py.

    bench/layers_by_gmsh.py SURFACE.stl FIRST GROWTH COUNT SIDE OUT.npz

The layers stand on the smallest shell of the surface, SIDE 1 along its normals, -1 against them. Needs Gmsh's module.
"""

import itertools
import sys

import gmsh
import numpy as np

TET, PRISM = 4, 6


def size_of(shell):
    box = np.array(gmsh.model.getBoundingBox(2, shell))
    return np.linalg.norm(box[3:] - box[:3])


def layers_of(surface, heights):
    """The shells beside the one that has layers, and what is extruded from that."""
    gmsh.merge(surface)
    gmsh.model.mesh.createTopology()
    shells = sorted((tag for _, tag in gmsh.model.getEntities(2)), key=size_of)
    wall, others = shells[0], shells[1:]
    extruded = gmsh.model.geo.extrudeBoundaryLayer([(2, wall)], [1] * len(heights), heights, True)
    return wall, others, extruded


def nodes_of(kind, nodes):
    _, connected = gmsh.model.mesh.getElementsByType(kind)
    return np.array(connected, np.int64).reshape(-1, nodes)


def main():
    surface, first, growth, count, side, out = sys.argv[1:]
    steps = [float(first) * float(growth) ** i for i in range(int(count))]
    heights = [int(side) * height for height in itertools.accumulate(steps)]
    gmsh.initialize()
    gmsh.option.setNumber("General.NumThreads", 1)
    _, others, extruded = layers_of(surface, heights)
    tops = [extruded[i - 1][1] for i in range(1, len(extruded)) if extruded[i][0] == 3]
    gmsh.model.geo.addVolume([gmsh.model.geo.addSurfaceLoop(tops + others)])
    gmsh.model.geo.synchronize()
    gmsh.option.setNumber("Mesh.Algorithm3D", 10)
    gmsh.model.mesh.generate(3)
    tags, places, _ = gmsh.model.mesh.getNodes()
    place = np.zeros(int(max(tags)) + 1, np.int64)
    place[np.array(tags, np.int64)] = np.arange(len(tags))
    tets, prisms = (place[nodes_of(kind, nodes)] for kind, nodes in ((TET, 4), (PRISM, 6)))
    np.savez(out, places=np.array(places).reshape(-1, 3), tets=tets, prisms=prisms)


if __name__ == "__main__":
    main()
