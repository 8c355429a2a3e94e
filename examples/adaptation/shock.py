#!/usr/bin/env python3
"""A field with a curved shock at the vertices of a mesh, as a solver would write it:

    shock.py MESH.mesh SOLUTION.sol
"""

import math
import sys


def vertices_of(name):
    words = iter(open(name, encoding="ascii").read().split())
    for word in words:
        if word == "Vertices":
            break
    count = int(next(words))
    return [[float(next(words)) for _ in range(3)][:2] for _ in range(count)]


def main():
    points = vertices_of(sys.argv[1])
    with open(sys.argv[2], "w", encoding="ascii") as out:
        out.write(f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(points)}\n1 1\n")
        for x, y in points:
            out.write(f"{math.tanh(50 * (x - 0.5 - 0.1 * math.sin(2 * math.pi * y)))!r}\n")
        out.write("End\n")


if __name__ == "__main__":
    main()
