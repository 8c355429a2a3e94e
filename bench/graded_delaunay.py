#!/usr/bin/env python3
"""Whether the tets of a graded body-centred lattice that come from a table are Delaunay tets: graded_delaunay.py [SEEDS]

Random octrees, balanced over faces, edges and corners, are filled with tets from a table, and every face between two of them is
asked whether the sphere of the one holds the far node of the other, in whole numbers. The table is that of Labelle and Shewchuk's
background grid (Isosurface stuffing, 2007), but for one case: round a face between equal cells, a corner at which both edges of
the face have a node in their middle is cut off, by a tet on each side, as theirs is not Delaunay there. Ties of cospherical
nodes are decided by moving centres into spheres first, then corners that a cell twice as large would have. Last come the same
faces with nodes shifted towards the larger cells, by so many 128ths of the smaller edge for each of them, as
mesh/spacing/level_shift.h does it: a corner of a larger cell, the middle of its edge, the middle of its face.
"""

import collections
import itertools
import random
import sys

from graded_templates import balance, cell_at

CORNERS = list(itertools.product((0, 1), repeat=3))
FINEST = 4
SCALE = 2 ** (FINEST + 3)
LIFT = 10**15
SHIFTS = [(0, 0, 0), (7, 5, 5), (7, 0, 0), (9, 0, 2)]


def children(cell):
    level, x, y, z = cell
    return [(level + 1, 2 * x + i, 2 * y + j, 2 * z + k) for i, j, k in CORNERS]


def random_octree(seed):
    chance, cells, stack = random.Random(seed), set(), [(0, 0, 0, 0)]
    while stack:
        cell = stack.pop()
        if cell[0] < 2 or (cell[0] < FINEST and chance.random() < 0.3):
            stack.extend(children(cell))
        else:
            cells.add(cell)
    balance(cells)
    return cells


def tets_of_cell(cells, corners, cell):
    """The tets that this cell makes, as four places each."""
    level = cell[0]
    s = SCALE >> level
    low = [c * s for c in cell[1:]]
    centre = tuple(x + s // 2 for x in low)
    for axis, side in itertools.product(range(3), (0, 1)):
        step = [(2 * side - 1) * (a == axis) for a in range(3)]
        other = cell_at(cells, level, *(c + d for c, d in zip(cell[1:], step)))
        if other is None or (other != "finer" and other[0] == level and side == 0):
            continue
        u, v = (axis + 1) % 3, (axis + 2) % 3

        def place(a, b):
            p = list(low)
            p[axis], p[u], p[v] = p[axis] + s * side, p[u] + a, p[v] + b
            return tuple(p)

        face = [place(0, 0), place(s, 0), place(s, s), place(0, s)]
        halves = [tuple((p + q) // 2 for p, q in zip(face[i], face[(i + 1) % 4])) for i in range(4)]
        if other == "finer":
            for i in range(4):
                for end in (face[i], face[(i + 1) % 4]):
                    yield centre, place(s // 2, s // 2), end, halves[i]
        elif other[0] == level:
            beyond = tuple(c + d * s for c, d in zip(centre, step))
            ring = []
            for i in range(4):
                if halves[i - 1] in corners and halves[i] in corners:
                    yield from ((x, halves[i - 1], face[i], halves[i]) for x in (centre, beyond))
                else:
                    ring.append(face[i])
                if halves[i] in corners:
                    ring.append(halves[i])
            yield from ((centre, beyond, ring[i - 1], ring[i]) for i in range(len(ring)))
        else:
            middle = [c * 2 * s + s for c in other[1:]]
            first = next(i for i in range(4) if face[i][u] == middle[u] and face[i][v] == middle[v])
            for i in (first + 1, first + 3):
                yield centre, face[first], face[i % 4], face[(first + 2) % 4]


def lattice(cells):
    """Tets, and of each node its rank (0 to 2: axes on which a corner is in the middle of a larger cell; 4: a centre) and shift."""
    levels, ranks, shifts = {}, {}, {}
    for cell in sorted(cells):
        s = SCALE >> cell[0]
        ranks[tuple(x * s + s // 2 for x in cell[1:])] = 4
        for d in CORNERS:
            p = tuple((x + i) * s for x, i in zip(cell[1:], d))
            levels[p] = max(levels.get(p, 0), cell[0])
    for p, level in levels.items():
        s = SCALE >> level
        ranks[p] = sum(x // s & 1 for x in p)
        larger = [d for d in CORNERS if (c := cell_at(cells, level, *(x // s - i for x, i in zip(p, d)))) and c != "finer" and c[0] < level]
        if ranks[p] < 3:
            shifts[p] = tuple(s * sum(-1 if d[axis] else 1 for d in larger) for axis in range(3))
    tets = [t for cell in sorted(cells) for t in tets_of_cell(cells, levels, cell)]
    return tets, ranks, shifts


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum((-1) ** i * rows[0][i] * determinant([r[:i] + r[i + 1 :] for r in rows[1:]]) for i in range(len(rows)))


def volume6(tet):
    return determinant([[q - p for p, q in zip(tet[0], x)] for x in tet[1:]])


def not_delaunay(tets, place, lowered):
    """Turned tets, faces between two tets, and those of them whose spheres are not empty, or are undecided."""
    beside, turned, counts = collections.defaultdict(list), 0, collections.Counter()
    oriented = []
    for tet in tets:
        sign = volume6(tet)
        oriented.append(tet if sign > 0 else (tet[1], tet[0]) + tet[2:])
        turned += volume6([place(p) for p in oriented[-1]]) <= 0
        for i in range(4):
            beside[tuple(sorted(tet[:i] + tet[i + 1 :]))].append((len(oriented) - 1, tet[i]))
    for pair in beside.values():
        if len(pair) == 1:
            continue
        assert len(pair) == 2
        (tet, _), (_, far) = pair
        e = place(far)
        rows = []
        for p in oriented[tet]:
            d = [a - b for a, b in zip(place(p), e)]
            rows.append(d + [LIFT * sum(x * x for x in d) - lowered[p] + lowered[far]])
        side = -determinant(rows)
        counts["faces"] += 1
        counts["inside"] += side > 0
        counts["undecided"] += side == 0
    return turned, dict(counts)


def main():
    for seed in range(1, 1 + (int(sys.argv[1]) if len(sys.argv) > 1 else 2)):
        tets, ranks, shifts = lattice(random_octree(seed))
        chance = random.Random(seed)
        lowered = {p: chance.randint(1, 9) * {4: 10**9, 0: 10**5}.get(rank, 1) for p, rank in ranks.items()}
        print(f"octree {seed}: {len(tets)} tets; turned, faces: perturbed", *not_delaunay(tets, lambda p: p, lowered))
        for steps in SHIFTS:

            def place(p):
                by = steps[ranks[p]] if p in shifts else 0
                return tuple(128 * x + by * d for x, d in zip(p, shifts.get(p, (0, 0, 0))))

            print(f"  shift {steps}:", *not_delaunay(tets, place, dict.fromkeys(ranks, 0)))


if __name__ == "__main__":
    main()
