"""Layers by snappyHexMesh of Debian's OpenFOAM round a body in a box: what its own report tells, for bench/layers_peers.py.

It makes a surface mesh of its own from cells of a lattice, whose edges next to the body are made about as long as those of the
given triangles: layers stand on these faces, and not on the triangles of the body.
"""

import os
import pathlib
import re

import numpy as np

import adapt

# Where Debian puts what OpenFOAM looks up; without it no program of it starts.
os.environ.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
HEADER = "FoamFile {{ version 2.0; format ascii; class dictionary; object {}; }}\n"
CONTROL = """application snappyHexMesh; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1;
"""
SCHEMES = """ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; } divSchemes { default none; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }
"""
SNAPPY = """castellatedMesh true; snap true; addLayers true; mergeTolerance 1e-6;
geometry {{ wall.stl {{ type triSurfaceMesh; name wall; }} }}
castellatedMeshControls {{ maxLocalCells 8000000; maxGlobalCells 8000000; minRefinementCells 10; nCellsBetweenLevels 2; features ();
  refinementSurfaces {{ wall {{ level ({level} {level}); }} }} resolveFeatureAngle 30; refinementRegions {{ }}
  locationInMesh ({inside}); allowFreeStandingZoneFaces true; }}
snapControls {{ nSmoothPatch 3; tolerance 2; nSolveIter 30; nRelaxIter 5; }}
addLayersControls {{ relativeSizes false; layers {{ "wall.*" {{ nSurfaceLayers {count}; }} }} expansionRatio {growth};
  firstLayerThickness {first}; minThickness {least}; nGrow 0; featureAngle 130; nRelaxIter 5; nSmoothSurfaceNormals 1;
  nSmoothNormals 3; nSmoothThickness 10; maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90;
  nBufferCellsNoExtrude 0; nLayerIter 50; }}
meshQualityControls {{ maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-16;
  minTetQuality 1e-30; minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05; minVolRatio 0.01;
  minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75; }}
"""


def triangles_of(stl):
    places = [line.split()[1:] for line in stl.read_text(encoding="ascii").splitlines() if "vertex" in line]
    return np.array(places, float).reshape(-1, 3, 3)


def block_of(low, high, cells):
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    corners = [corners[i] for i in (0, 1, 3, 2, 4, 5, 7, 6)]
    vertices = " ".join("({} {} {})".format(*corner) for corner in corners)
    return (f"convertToMeters 1; vertices ({vertices}); blocks (hex (0 1 2 3 4 5 6 7) ({cells[0]} {cells[1]} {cells[2]}) "
            "simpleGrading (1 1 1)); edges (); boundary (far { type patch; faces ((0 3 2 1) (4 5 6 7) (0 1 5 4) (1 2 6 5) "
            "(2 3 7 6) (3 0 4 7)); }); mergePatchPairs ();\n")


def write_case(case, wall, plane, heights):
    """@param plane: whether the body ends at its lowest y, where the box is to end as well."""
    triangles = triangles_of(wall)
    low, high = triangles.min(axis=(0, 1)), triangles.max(axis=(0, 1))
    size = (high - low).max()
    edges = np.median(np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2))
    low, high = low - size * np.array([1, 0 if plane else 1, 1]), high + size
    coarse = edges * 2 ** 6
    cells = np.maximum(1, np.round((high - low) / coarse)).astype(int)
    first, growth, count = heights
    (case / "constant" / "triSurface").mkdir(parents=True)
    (case / "constant" / "triSurface" / "wall.stl").write_bytes(wall.read_bytes())
    (case / "system").mkdir()
    inside = " ".join(str(x) for x in low + 0.0123 * (high - low))
    texts = {"controlDict": CONTROL, "fvSchemes": SCHEMES, "fvSolution": "solvers { }\n", "blockMeshDict": block_of(low, high, cells),
             "snappyHexMeshDict": SNAPPY.format(level=6, inside=inside, count=count, growth=growth, first=first, least=first / 10)}
    for name, text in texts.items():
        (case / "system" / name).write_text(HEADER.format(name) + text, encoding="ascii")


def layers_of(wall, plane, heights, folder, limit, memory):
    """Faces with layers, layers on average, their share of the thickness in %, all cells; and what it took."""
    case = pathlib.Path(folder) / "snappy"
    write_case(case, wall, plane, heights)
    done = case / "done"
    adapt.run(["sh", "-c", "blockMesh && touch done"], case, done, limit)
    run = adapt.run(["prlimit", f"--as={memory}", "sh", "-c", "snappyHexMesh -overwrite && touch done"], case, done, limit)
    report = re.findall(r"^wall\S*\s+(\d+)\s+([\d.e+-]+)\s+([\d.e+-]+)\s+([\d.e+-]+)\s*$", run.stdout, re.MULTILINE)
    cells = re.findall(r"Layer mesh : cells:(\d+)", run.stdout)
    if not report or not cells:
        raise adapt.Failed("no report of layers")
    faces = np.array([[float(word) for word in row] for row in report])
    total = faces[:, 0].sum()
    return int(total), (faces[:, 0] @ faces[:, 1]) / total, (faces[:, 0] @ faces[:, 3]) / total, int(cells[-1]), run
