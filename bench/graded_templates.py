#!/usr/bin/env python3
"""How well shaped a graded body-centred lattice is when every tet of it comes from a table, transitions included.

  bench/graded_templates.py GROWTH [FINEST_LEVEL]      needs numpy; 0.3 6 takes some seconds

An octree of the unit cube whose cells grow with the distance from a small ball in its middle, balanced over faces, edges and
corners, is filled with the tets of Labelle and Shewchuk's background grid (Isosurface stuffing, 2007): every cell has a centre;
across a face between equal cells each edge of the face spans a tet with the two centres, or two where the edge has a node in
its middle; a face towards four smaller cells is a fan of eight triangles seen from the centre; a face towards a larger cell is two
triangles, split along the diagonal to the middle of the larger cell's face. Printed are the shares of these kinds and their
radius ratios (3 inradius / circumradius), as they come and after nodes have been moved.
"""

import collections
import itertools
import sys

import numpy as np

KINDS = ["between equal cells", "with half an edge", "towards smaller cells", "towards a larger cell"]
MIDDLE = np.array([0.5, 0.5, 0.5])
BALL = 0.08
CORNERS = list(itertools.product((0, 1), repeat=3))


def children(cell):
    level, x, y, z = cell
    return [(level + 1, 2 * x + i, 2 * y + j, 2 * z + k) for i, j, k in CORNERS]


def graded_cells(growth, finest):
    """The leaves (level, x, y, z) of the octree, before balancing."""
    cells, stack = set(), [(0, 0, 0, 0)]
    while stack:
        cell = stack.pop()
        edge = 2.0 ** -cell[0]
        away = np.linalg.norm((np.array(cell[1:]) + 0.5) * edge - MIDDLE)
        wanted = 2.0**-finest + growth * max(0, away - BALL)
        if cell[0] < finest and (edge > wanted or cell[0] < 3):
            stack.extend(children(cell))
        else:
            cells.add(cell)
    return cells


def cell_at(cells, level, x, y, z):
    """The leaf that holds this cell; None outside, "finer" where it is divided."""
    if min(x, y, z) < 0 or max(x, y, z) >= 2**level:
        return None
    while level >= 0:
        if (level, x, y, z) in cells:
            return (level, x, y, z)
        level, x, y, z = level - 1, x >> 1, y >> 1, z >> 1
    return "finer"


def balance(cells):
    """Divides cells until those that touch differ by one level at most."""
    work = list(cells)
    while work:
        cell = work.pop()
        if cell not in cells:
            continue
        for step in itertools.product((-1, 0, 1), repeat=3):
            other = cell_at(cells, cell[0], *(c + s for c, s in zip(cell[1:], step)))
            if other and other != "finer" and other[0] < cell[0] - 1:
                cells.discard(other)
                cells.update(children(other))
                work.extend(children(other) + [cell])


def tets_of_cell(cells, corners, cell, scale):
    """Yields (kind, four places) of the tets that this cell makes; places are integers, `scale` of them an edge of level 0."""
    level = cell[0]
    s = scale >> level
    low = np.array(cell[1:]) * s
    centre = tuple(low + s // 2)
    for axis, side in itertools.product(range(3), (0, 1)):
        step = np.zeros(3, int)
        step[axis] = 1 if side else -1
        other = cell_at(cells, level, *(np.array(cell[1:]) + step))
        if other is None:
            continue
        u, v = (axis + 1) % 3, (axis + 2) % 3

        def place(a, b):
            p = low.copy()
            p[axis] += s * side
            p[u] += a
            p[v] += b
            return tuple(p)

        face = [place(0, 0), place(s, 0), place(s, s), place(0, s)]
        edges = [(face[i], face[(i + 1) % 4]) for i in range(4)]
        halves = [tuple((np.array(a) + np.array(b)) // 2) for a, b in edges]
        if other == "finer":
            for (a, b), m in zip(edges, halves):
                yield from ((2, (centre, place(s // 2, s // 2), *half)) for half in ((a, m), (m, b)))
        elif other[0] == level and side == 1:
            beyond = tuple(np.array(centre) + step * s)
            for (a, b), m in zip(edges, halves):
                if m in corners:
                    yield from ((1, (centre, beyond, *half)) for half in ((a, m), (m, b)))
                else:
                    yield 0, (centre, beyond, a, b)
        elif other[0] < level:
            middle = np.array(other[1:]) * 2 * s + s
            first = next(i for i in range(4) if face[i][u] == middle[u] and face[i][v] == middle[v])
            for i in (first + 1, first + 3):
                yield 3, (centre, face[first], face[i % 4], face[(first + 2) % 4])


def lattice(cells, finest):
    """Points in the unit cube, tets of positive volume and their kinds."""
    scale = 2 ** (finest + 2)
    corners = {tuple((np.array(cell[1:]) + d) * (scale >> cell[0])) for cell in cells for d in map(np.array, CORNERS)}
    numbers, tets, kinds = {}, [], []
    for cell in sorted(cells):
        for kind, places in tets_of_cell(cells, corners, cell, scale):
            tets.append([numbers.setdefault(p, len(numbers)) for p in places])
            kinds.append(kind)
    points, tets = np.array(list(numbers)) / scale, np.array(tets)
    turned = volumes(points[tets]) < 0
    tets[turned] = tets[turned][:, [1, 0, 2, 3]]
    return points, tets, np.array(kinds)


def volumes(a):
    return np.einsum("ij,ij->i", np.cross(a[:, 1] - a[:, 0], a[:, 2] - a[:, 0]), a[:, 3] - a[:, 0]) / 6


def radius_ratios(a):
    volume = volumes(a)

    def area(p, q, r):
        return 0.5 * np.linalg.norm(np.cross(a[:, q] - a[:, p], a[:, r] - a[:, p]), axis=1)

    def product(p, q, r, s):
        return np.linalg.norm(a[:, p] - a[:, q], axis=1) * np.linalg.norm(a[:, r] - a[:, s], axis=1)

    inradius = 3 * volume / (area(0, 1, 2) + area(0, 1, 3) + area(0, 2, 3) + area(1, 2, 3))
    x, y, z = product(0, 1, 2, 3), product(0, 2, 1, 3), product(0, 3, 1, 2)
    circumradius = np.sqrt(np.maximum((x + y + z) * (x + y - z) * (x - y + z) * (y + z - x), 1e-300)) / (24 * np.abs(volume))
    return 3 * inradius / circumradius


def move_nodes(points, tets, kinds):
    """One sweep: each node at a transition goes towards the mean of its neighbours where its tets become rounder in the mean."""
    tets_at = collections.defaultdict(list)
    for t, nodes in enumerate(tets):
        for node in nodes:
            tets_at[node].append(t)
    for node, mine in tets_at.items():
        if not any(kinds[t] for t in mine) or points[node].min() < 0.05 or points[node].max() > 0.95:
            continue
        here, best = points[node].copy(), points[node].copy()
        mean = radius_ratios(points[tets[mine]]).mean()
        around = np.unique(tets[mine])
        target = points[around[around != node]].mean(axis=0)
        for share in (1, 0.5):
            points[node] = here + share * (target - here)
            ratios = radius_ratios(points[tets[mine]])
            if ratios.min() > 0.3 and ratios.mean() > mean:
                mean, best = ratios.mean(), points[node].copy()
        points[node] = best


def main():
    growth = float(sys.argv[1])
    finest = int(sys.argv[2]) if len(sys.argv) > 2 else 6
    cells = graded_cells(growth, finest)
    balance(cells)
    points, tets, kinds = lattice(cells, finest)
    places = points[tets]
    inner = (places.min(axis=(1, 2)) > 0.12) & (places.max(axis=(1, 2)) < 0.88)
    print(f"growth {growth}: {inner.sum()} tets, cells by level {dict(sorted(collections.Counter(c[0] for c in cells).items()))}")
    for when in ("as they come", "moved once", "moved twice"):
        ratios = radius_ratios(points[tets])
        each = ", ".join(f"{name} {(inner & (kinds == k)).sum() / inner.sum():.1%} {ratios[inner & (kinds == k)].mean():.3f}" for k, name in enumerate(KINDS))
        print(f"{when}: mean {ratios[inner].mean():.4f}, least {ratios[inner].min():.3f}; {each}")
        move_nodes(points, tets, kinds)


if __name__ == "__main__":
    main()
