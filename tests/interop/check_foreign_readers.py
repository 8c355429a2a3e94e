#!/usr/bin/env python3
"""Programs that are not ours read what `tetfarm export` writes.

check_foreign_readers.py PROGRAM

Meshes the ONERA M6 wing of $TETFARM_DATA in 16 sub-domains, without and with boundary layers, exports it to every format,
and in 5 parts to those that have parts, and has VTK, meshio, gmsh, cgnscheck, OpenFOAM and code_saturne's preprocessor read the
files: counts and volume must be those of the mesh. Prints tables. `./dev test interop` gets the
programs from Debian first. Ends with 77 when the data or a program is missing, and with 1 when a reader refuses a file or
finds another mesh.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PREPROCESSOR = "/usr/lib/code_saturne/cs_preprocess"
SUBDOMAINS = 16
PARTITIONS = 5
LAYERS = "wing_*,te,tip:first=1e-4,growth=1.2,count=15"
# Where Debian puts what OpenFOAM looks up; without it no program of it starts.
ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": "/usr/share/openfoam"}
SKIPPED = 77

CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
application potentialFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
writeControl timeStep; writeInterval 1; writePrecision 16;
"""
SCHEMES = """FoamFile { version 2.0; format ascii; class dictionary; object fvSchemes; }
ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss linear; div(div(phi,U)) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""
SOLUTION = """FoamFile { version 2.0; format ascii; class dictionary; object fvSolution; }
solvers { Phi { solver PCG; preconditioner DIC; tolerance 1e-06; relTol 0.01; }
          p { solver PCG; preconditioner DIC; tolerance 1e-06; relTol 0.01; } }
potentialFlow { nNonOrthogonalCorrectors 3; }
"""
PARTS = """FoamFile { version 2.0; format ascii; class dictionary; object decomposeParDict; }
numberOfSubdomains COUNT; method none;
"""


class Wrong(Exception):
    """A reader refused a file or found another mesh."""


def run(words, folder):
    done = subprocess.run([str(word) for word in words], cwd=folder, text=True, env=ENVIRONMENT,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        raise Wrong(f"{words[0]} ends with {done.returncode}: {done.stdout[-600:]}")
    return done.stdout


def number(pattern, text):
    found = re.search(pattern, text)
    if not found:
        raise Wrong(f"it does not say {pattern}: {text[-600:]}")
    return float(found.group(1))


class Export:
    """A mesh in so many parts, and its files in a folder."""

    def __init__(self, program, mesh, folder, parts, options=()):
        self.program, self.mesh_folder, self.folder = program, mesh, folder
        self.parts, self.options = parts, list(options)
        folder.mkdir(exist_ok=True)
        self.mesh = json.loads(run([program, "quality", mesh, "--json"], folder))
        self.expected = {"nodes": self.mesh["nodes"], "tets": self.mesh["elements"],
                         "triangles": self.mesh["boundary_triangles"],
                         "volume": self.mesh["volume"]}

    def write(self, form, name):
        run([self.program, "export", self.mesh_folder, "--format", form, "-o", name] + self.options, self.folder)
        return name

    def compare(self, found):
        for what, value in found.items():
            wanted = self.expected[what]
            if abs(value - wanted) > 1e-6 * abs(wanted):
                raise Wrong(f"{what}: {value} instead of {wanted}")


def library(export, which, name):
    script = pathlib.Path(__file__).parent / "read_counts.py"
    said = run(["/usr/bin/python3", script, which, name], export.folder)
    return json.loads(said.strip().splitlines()[-1])


def with_library(which, without_triangles=False):
    def check(export, name):
        found = library(export, which, name)
        if without_triangles:
            del found["triangles"]
        export.compare(found)
        return found
    return check


def with_gmsh(export, name):
    said = run(["gmsh", "-check", name], export.folder)
    if "Error" in said or "Warning" in said:
        raise Wrong(said)
    export.compare(read := {"nodes": number(r"(\d+) nodes", said)})
    return {**read, "elements": int(number(r"(\d+) elements", said))}


def gmsh_parts_merged(export, name):
    """All split files in one file, in which gmsh keeps a shared node for each of them."""
    stem = name.rsplit(".", 1)[0]
    parts = [f"{stem}_{i}.msh" for i in range(1, export.parts + 1)]
    text = "".join(f'Merge "{part}";\n' for part in parts)
    text += 'Mesh.SaveAll=1;\nMesh.MshFileVersion=2.2;\nSave "merged.msh";\n'
    (export.folder / "merge.geo").write_text(text)
    run(["gmsh", "-0", "merge.geo"], export.folder)
    return "merged.msh"


def with_gmsh_parts(export, name):
    found = library(export, "meshio-places", gmsh_parts_merged(export, name))
    export.compare(found)
    return found


def with_gmsh_ghosts(export, name):
    """Each split file by itself: gmsh writes the ghosts again that it found in it."""
    stem, ghosts = name.rsplit(".", 1)[0], 0
    export.write("comm-text", "tables")
    for i in range(1, export.parts + 1):
        (export.folder / "one.geo").write_text(
            f'Merge "{stem}_{i}.msh";\nMesh.SaveAll=1;\nMesh.MshFileVersion=4.1;\nMesh.Binary=0;\nSave "again.msh";\n')
        said = run(["gmsh", "-0", "one.geo"], export.folder)
        if "Error" in said or "Warning" in said:
            raise Wrong(said[-800:])
        found = number(r"\$GhostElements\n(\d+)\n", (export.folder / "again.msh").read_text())
        table = (export.folder / "tables" / f"part-{i - 1}.comm.txt").read_text()
        wanted = number(r"\nghosts (\d+)", table)
        if found != wanted:
            raise Wrong(f"{found} ghosts of part {i} instead of {wanted}")
        ghosts += int(found)
    return {"ghosts": ghosts}


def with_cgnscheck(export, name):
    said = run(["cgnscheck", name], export.folder)
    errors = int(number(r"(\d+) errors?", said)) if "error" in said.lower() else 0
    if errors:
        raise Wrong(said[-800:])
    return {}


def with_preprocessor(export, name):
    said = run([PREPROCESSOR, "--out", "saturne.out", name], export.folder)
    found = {"nodes": number(r"Number of vertices[ :]+(\d+)", said),
             "tets": number(r"Number of cells[ :]+(\d+)", said),
             "triangles": number(r"Number of boundary faces[ :]+(\d+)", said)}
    export.compare(found)
    return found


def make_case(export, name, patches):
    folder = export.folder / name
    for name, text in (("controlDict", CONTROL), ("fvSchemes", SCHEMES), ("fvSolution", SOLUTION),
                       ("decomposeParDict", PARTS.replace("COUNT", str(export.parts)))):
        (folder / "system").mkdir(parents=True, exist_ok=True)
        (folder / "system" / name).write_text(text)
    fields = {"U": ("volVectorField", "[0 1 -1 0 0 0 0]", "(1 0 0)"),
              "p": ("volScalarField", "[0 2 -2 0 0 0 0]", "0")}
    for processor in ["."] + [f"processor{i}" for i in range(export.parts)]:
        if not (folder / processor).is_dir():
            continue
        (folder / processor / "0").mkdir(exist_ok=True)
        for name, (kind, dimensions, value) in fields.items():
            (folder / processor / "0" / name).write_text(
                f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"
                f"dimensions {dimensions}; internalField uniform {value};\n"
                f"boundaryField {{ {boundary(name, patches)} \"procBoundary.*\" "
                f"{{ type processor; value uniform {value}; }} }}\n")


def boundary(field, patches):
    """Uniform flow past the wing; the outer patch has it fixed."""
    text = ""
    for patch in patches:
        outer = patch.startswith(("far", "outer"))
        kinds = {("U", True): "type freestream; freestreamValue uniform (1 0 0);",
                 ("U", False): "type slip;",
                 ("p", True): "type fixedValue; value uniform 0;",
                 ("p", False): "type zeroGradient;"}
        text += f"{patch} {{ {kinds[field, outer]} }} "
    return text


def check_mesh(export, name, words=("checkMesh",)):
    said = run(words, export.folder / name)
    if "Mesh OK" not in said:
        raise Wrong(said[-1500:])
    found = {"tets": number(r"\n\s+cells:\s+(\d+)", said)}
    return found, said


def with_check_mesh(export, name):
    make_case(export, name, [])
    found, said = check_mesh(export, name)
    found["nodes"] = number(r"\n\s+points:\s+(\d+)", said)
    found["volume"] = number(r"Total volume = ([\d.e+-]+?)\.? ", said)
    export.compare(found)
    return found


def with_check_mesh_parallel(export, name):
    make_case(export, name, [])
    mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", export.parts]
    found, said = check_mesh(export, name, mpi + ["checkMesh", "-parallel"])
    found["volume"] = number(r"Total volume = ([\d.e+-]+?)\.? ", said)
    export.compare(found)
    return found


def with_reconstruct(export, name):
    run(["reconstructParMesh", "-constant", "-mergeTol", "1e-9"], export.folder / name)
    found, said = check_mesh(export, name)
    found["nodes"] = number(r"\n\s+points:\s+(\d+)", said)
    export.compare(found)
    return found


def with_gmsh_to_foam(export, name):
    case = export.folder / "converted"
    case.mkdir()
    make_case(export, "converted", [])
    run(["gmshToFoam", "../" + name], case)
    found, said = check_mesh(export, "converted")
    found["nodes"] = number(r"\n\s+points:\s+(\d+)", said)
    export.compare(found)
    return found


def with_potential_foam(export, name):
    patches = re.findall(r"\n    (\w[\w.-]*)\n    \{\n        type            patch",
                         (export.folder / name / "processor0/constant/polyMesh/boundary").read_text())
    make_case(export, name, patches)
    said = run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", export.parts,
                "potentialFoam", "-parallel", "-writep"], export.folder / name)
    if "End" not in said:
        raise Wrong(said[-800:])
    return {"continuity": number(r"Continuity error = ([\d.e+-]+)", said)}


CHECKS = [
    ("vtkhdf", "m.vtkhdf", "VTK", with_library("vtk")),
    ("pvtu", "m.pvtu", "VTK", with_library("vtk")),
    ("cgns", "m.cgns", "cgnscheck", with_cgnscheck),
    ("cgns", "m.cgns", "VTK", with_library("vtk", without_triangles=True)),
    ("cgns", "m.cgns", "meshio", with_library("meshio", without_triangles=True)),
    ("cgns", "m.cgns", "code_saturne preprocessor", with_preprocessor),
    ("lb8.ugrid", "m.lb8.ugrid", "meshio", with_library("meshio")),
    ("b8.ugrid", "m.b8.ugrid", "meshio", with_library("meshio")),
    ("lb8l.ugrid", "m.lb8l.ugrid", "meshio", with_library("meshio")),
    ("b8l.ugrid", "m.b8l.ugrid", "meshio", with_library("meshio")),
    ("msh41", "m41.msh", "gmsh -check", with_gmsh),
    ("msh41", "m41.msh", "meshio", with_library("meshio")),
    ("msh41-text", "m41t.msh", "gmsh -check", with_gmsh),
    ("msh41-text", "m41t.msh", "meshio", with_library("meshio")),
    ("msh41-split", "parts.msh", "gmsh, all parts", with_gmsh_parts),
    ("msh41-ghosts", "ghosts.msh", "gmsh, each part", with_gmsh_ghosts),
    ("msh22", "m22.msh", "gmsh -check", with_gmsh),
    ("msh22", "m22.msh", "meshio", with_library("meshio")),
    ("msh22", "m22.msh", "OpenFOAM gmshToFoam, checkMesh", with_gmsh_to_foam),
    ("su2", "m.su2", "meshio", with_library("meshio")),
    ("meshb", "m.meshb", "meshio", with_library("meshio")),
    ("tetgen", "m.node", "meshio", with_library("meshio", without_triangles=True)),
    ("openfoam", "whole", "OpenFOAM checkMesh", with_check_mesh),
    ("openfoam-decomposed", "parts", "OpenFOAM checkMesh, parallel", with_check_mesh_parallel),
    ("openfoam-decomposed", "parts", "OpenFOAM reconstructParMesh, checkMesh", with_reconstruct),
    ("openfoam-decomposed", "parts", "OpenFOAM potentialFoam, parallel", with_potential_foam),
]


# What is said of a mesh of all types of cells.
KINDS = ("nodes", "tets", "pyramids", "prisms", "hexes", "triangles", "quads")


def mixed(which, *left_out):
    def check(export, name):
        found = library(export, which, name)
        for what in left_out:
            found.pop(what, None)
        export.compare(found)
        return found
    return check


def mixed_with_gmsh_parts(export, name):
    found = library(export, "meshio-mixed-places", gmsh_parts_merged(export, name))
    export.compare(found)
    return found


def mixed_with_preprocessor(export, name):
    said = run([PREPROCESSOR, "--out", "saturne.out", name], export.folder)
    found = {"nodes": number(r"Number of vertices[ :]+(\d+)", said),
             "cells": number(r"Number of cells[ :]+(\d+)", said),
             "boundary faces": number(r"Number of boundary faces[ :]+(\d+)", said)}
    export.compare(found)
    return found


def mixed_counts(said, *more):
    """What checkMesh says of each type of cell."""
    numbers = {"hexes": r"\n\s+hexahedra:\s+(\d+)", "prisms": r"\n\s+prisms:\s+(\d+)",
               "pyramids": r"\n\s+pyramids:\s+(\d+)", "tets": r"\n\s+tetrahedra:\s+(\d+)",
               "nodes": r"\n\s+points:\s+(\d+)", "volume": r"Total volume = ([\d.e+-]+?)\.? "}
    return {what: number(pattern, said) for what, pattern in numbers.items() if what != "nodes" or "nodes" in more}


def mixed_with_gmsh_to_foam(export, name):
    case = export.folder / "converted"
    case.mkdir()
    make_case(export, "converted", [])
    run(["gmshToFoam", "../" + name], case)
    found = mixed_counts(run(["checkMesh"], case), "nodes")
    export.compare(found)
    return found


def mixed_with_check_mesh(export, name):
    make_case(export, name, [])
    found = mixed_counts(check_mesh(export, name)[1], "nodes")
    export.compare(found)
    return found


def mixed_with_check_mesh_parallel(export, name):
    make_case(export, name, [])
    mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", export.parts]
    found = mixed_counts(check_mesh(export, name, mpi + ["checkMesh", "-parallel"])[1])
    export.compare(found)
    return found


MIXED_CHECKS = [
    ("vtkhdf", "m.vtkhdf", "VTK", mixed("vtk-mixed")),
    ("pvtu", "m.pvtu", "VTK", mixed("vtk-mixed")),
    ("cgns", "m.cgns", "cgnscheck", with_cgnscheck),
    ("cgns", "m.cgns", "VTK", mixed("vtk-mixed", "volume")),  # its wedges stay as CGNS has them
    ("cgns", "m.cgns", "code_saturne preprocessor", mixed_with_preprocessor),
    ("lb8.ugrid", "m.lb8.ugrid", "meshio", mixed("meshio-mixed")),
    ("b8.ugrid", "m.b8.ugrid", "meshio", mixed("meshio-mixed")),
    ("lb8l.ugrid", "m.lb8l.ugrid", "meshio", mixed("meshio-mixed")),
    ("b8l.ugrid", "m.b8l.ugrid", "meshio", mixed("meshio-mixed")),
    ("msh41", "m41.msh", "gmsh -check", with_gmsh),
    ("msh41", "m41.msh", "meshio", mixed("meshio-mixed")),
    ("msh41-text", "m41t.msh", "meshio", mixed("meshio-mixed")),
    ("msh22", "m22.msh", "gmsh -check", with_gmsh),
    ("msh22", "m22.msh", "meshio", mixed("meshio-mixed")),
    ("msh22", "m22.msh", "OpenFOAM gmshToFoam, checkMesh", mixed_with_gmsh_to_foam),
    ("su2", "m.su2", "meshio", mixed("meshio-mixed", "volume")),  # it takes wedges for Gmsh's
    ("meshb", "m.meshb", "meshio", mixed("meshio-mixed")),
    ("openfoam", "whole", "OpenFOAM checkMesh", mixed_with_check_mesh),
    ("openfoam-decomposed", "parts", "OpenFOAM checkMesh, parallel", mixed_with_check_mesh_parallel),
]


def mixed_with_reconstruct(export, name):
    run(["reconstructParMesh", "-constant", "-mergeTol", "1e-9"], export.folder / name)
    found = mixed_counts(check_mesh(export, name, ("checkMesh", "-allTopology"))[1], "nodes")
    export.compare(found)
    return found


# Of a mesh with boundary layers: also what is said of many parts.
LAYERED_CHECKS = MIXED_CHECKS + [
    ("cgns", "m.cgns", "meshio", mixed("meshio-mixed", "volume", "triangles", "quads")),  # no surface
    ("msh41-split", "parts.msh", "gmsh, all parts", mixed_with_gmsh_parts),
    ("msh41-ghosts", "ghosts.msh", "gmsh, each part", with_gmsh_ghosts),
    ("openfoam-decomposed", "parts", "OpenFOAM reconstructParMesh, checkMesh", mixed_with_reconstruct),
    ("openfoam-decomposed", "parts", "OpenFOAM potentialFoam, parallel", with_potential_foam),
]


def mixed_table(export, title, checks, formats=None):
    """The same as table() for a mesh of several types of cells."""
    wrong = 0
    print(f"\n{title}:\n")
    print("| format | read by | " + " | ".join(KINDS) + " | |\n|---|---|" + "--:|" * len(KINDS) + "---|")
    for form, name, reader, check in checks:
        if formats and form not in formats:
            continue
        try:
            export.write(form, name)
            found, said = check(export, name), "the same"
        except Wrong as error:
            found, said = {}, f"WRONG: {error}"
            wrong += 1
        counts = " | ".join(f"{int(found[what])}" if what in found else "" for what in KINDS)
        print(f"| `{form}` | {reader} | {counts} | {said}{more_of(found)} |", flush=True)
    return wrong


def mixed_export(program, mesh, folder, parts, options=()):
    export = Export(program, mesh, folder, parts, options)
    mesh = export.mesh
    for kind in ("pyramids", "prisms", "hexes"):
        export.expected[kind] = mesh.get(kind, {"count": 0})["count"]
    export.expected["quads"] = mesh.get("boundary_quads", 0)
    export.expected["cells"] = sum(export.expected[k] for k in ("tets", "pyramids", "prisms", "hexes"))
    export.expected["boundary faces"] = mesh["boundary_triangles"] + export.expected["quads"]
    return export


# Formats in which parts are seen.
WITH_PARTS = ("vtkhdf", "pvtu", "cgns", "msh41-split", "msh41-ghosts", "openfoam-decomposed")


def table(export, formats=None):
    """Prints a line for each check; returns how many went wrong."""
    wrong, written = 0, set()
    print(f"\n{export.parts} parts:\n")
    print("| format | read by | nodes | tetrahedra | triangles | |\n|---|---|--:|--:|--:|---|")
    for form, name, reader, check in CHECKS:
        if formats and form not in formats:
            continue
        try:
            if form not in written:
                export.write(form, name)
                written.add(form)
            found, said = check(export, name), "the same"
        except Wrong as error:
            found, said = {}, f"WRONG: {error}"
            wrong += 1
        counts = " | ".join(f"{int(found[what])}" if what in found else ""
                            for what in ("nodes", "tets", "triangles"))
        print(f"| `{form}` | {reader} | {counts} | {said}{more_of(found)} |", flush=True)
    return wrong


def more_of(found):
    """What some checks tell besides counts."""
    more = f", continuity error {found['continuity']:.2g}" if "continuity" in found else ""
    return more + (f", {found['ghosts']} ghosts" if "ghosts" in found else "")


def layered_tables(program, surface, folder):
    """A mesh with boundary layers, as it was meshed and in even parts; how many checks went wrong."""
    run([program, "run", surface, "--subdomains", SUBDOMAINS, "--layers", LAYERS, "-o", "layered", "--progress", "none"],
        folder)
    parts = json.loads(run([program, "quality", folder / "layered", "--json"], folder))["subdomains"]
    as_meshed = mixed_export(program, folder / "layered", folder / "layers_as_meshed", parts)
    in_parts = mixed_export(program, folder / "layered", folder / "layers_in_parts", PARTITIONS,
                            ["--partitions", PARTITIONS])
    print("\nexpected:", as_meshed.expected)
    return (mixed_table(as_meshed, f"boundary layers, {parts} parts", LAYERED_CHECKS)
            + mixed_table(in_parts, f"boundary layers, {PARTITIONS} parts", LAYERED_CHECKS, WITH_PARTS))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", type=pathlib.Path)
    options = parser.parse_args()
    data = pathlib.Path(os.environ.get("TETFARM_DATA", "no TETFARM_DATA"))
    surface = data.resolve() / "onera_m6_sharp_te" / "onera_m6_sharp_te.msh.gz"
    missing = [name for name in ("gmsh", "cgnscheck", "checkMesh", "mpirun", PREPROCESSOR)
               if shutil.which(name) is None]
    if missing or not surface.is_file():
        print("missing:", missing or surface)
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        folder, program = pathlib.Path(folder), options.program.resolve()
        run([program, "run", surface, "--subdomains", SUBDOMAINS, "-o", "out", "--progress", "none"], folder)
        as_meshed = Export(program, folder / "out", folder / "as_meshed", SUBDOMAINS)
        in_parts = Export(program, folder / "out", folder / "in_parts", PARTITIONS, ["--partitions", PARTITIONS])
        print("expected:", as_meshed.expected)
        all_types = mixed_export(program, pathlib.Path(__file__).resolve().parent / "all_types.msh",
                                 folder / "all_types", 2)
        wrong = table(as_meshed) + table(in_parts, WITH_PARTS)
        wrong += mixed_table(all_types, "all types of cells", MIXED_CHECKS)
        wrong += layered_tables(program, surface, folder)
        return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
