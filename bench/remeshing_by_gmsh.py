#!/usr/bin/env python3
"""A closed surface of triangles remeshed by Gmsh, for bench/remeshing.py: parametrized, then its frontal mesher.

    bench/remeshing_by_gmsh.py IN.stl OUT.stl EDGE

Prints one line of JSON with the CPU seconds without reading and writing. Needs Gmsh's module.
"""

import json
import math
import sys
import time

import gmsh

SHARP_DEG = 30
FRONTAL = 6


def main():
    surface, out, edge = sys.argv[1], sys.argv[2], float(sys.argv[3])
    gmsh.initialize()
    for option, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("Mesh.Algorithm", FRONTAL), ("Mesh.Binary", 1),
                          ("Mesh.MeshSizeMin", edge), ("Mesh.MeshSizeMax", edge), ("Mesh.MeshSizeExtendFromBoundary", 0)):
        gmsh.option.setNumber(option, value)
    gmsh.merge(surface)
    begin = time.process_time()
    gmsh.model.mesh.classifySurfaces(math.radians(SHARP_DEG), True, True, math.pi)
    gmsh.model.mesh.createGeometry()
    gmsh.model.geo.synchronize()
    gmsh.model.mesh.generate(2)
    seconds = time.process_time() - begin
    gmsh.write(out)
    gmsh.finalize()
    print(json.dumps({"seconds": seconds}))


if __name__ == "__main__":
    main()
