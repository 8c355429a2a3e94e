#!/usr/bin/env python3
"""Meshes that the program wrote, read back as arrays, and files that are none."""

import os
import pathlib
import random
import struct
import subprocess
import sys
import unittest

import support
import tetfarm

try:
    import h5py
except ImportError:
    h5py = None

FORMS = ["vtkhdf", "lb8.ugrid", "b8.ugrid", "lb8l.ugrid", "b8l.ugrid"]


def arrays_of(mesh):
    return {name: getattr(mesh, name).tolist() for name in
            ("points", "tets", "pyramids", "prisms", "hexes", "triangles", "triangle_patches", "quads", "quad_patches")}


def needs_h5py(test):
    return test if h5py or os.environ.get("CI") else unittest.skip("h5py is not there (python3-h5py)")(test)


class OfLayers(support.InFolder):
    """Prisms, pyramids and quads, in three sub-domains and more."""

    def setUp(self):
        super().setUp()
        support.shape("wing", "wing.stl", 0.2)
        self.result = tetfarm.run("wing.stl", "out", layers="wing:first=0.004,growth=1.4,count=4", subdomains=2,
                                  format=FORMS if h5py else FORMS[1:])

    def test_have_the_cells_and_the_volume_of_the_result_in_each_format(self):
        figures = self.result.figures
        for form in FORMS if h5py else FORMS[1:]:
            mesh = tetfarm.read_mesh(f"out/wing.{form}")
            for kind in ("tets", "pyramids", "prisms"):
                self.assertEqual(len(getattr(mesh, kind)), figures[kind], (form, kind))
                self.assertGreater(figures[kind], 0)
                self.assertGreater(support.volumes_of(mesh, kind).min(), 0, (form, kind))
            self.assertEqual((len(mesh.triangles), len(mesh.quads), len(mesh.points)),
                             (figures["boundary_triangles"], figures["boundary_quads"], figures["nodes"]))
            self.assertAlmostEqual(support.volume_of(mesh), self.result.volume, delta=1e-10 * self.result.volume)
            self.assertAlmostEqual(support.enclosed_by(mesh), self.result.volume, delta=1e-10 * self.result.volume)
            self.assertEqual(support.unmatched_faces(mesh), 0)

    def test_have_the_patches_of_the_surface(self):
        mesh = self.result.read_mesh()
        self.assertEqual(mesh.patch_names, ["symmetry", "wing", "far field"])
        self.assertEqual(len(mesh.triangles_of("wing")), self.result.figures["layers"]["wall_triangles"])
        self.assertEqual({mesh.patch_name(patch) for patch in mesh.quad_patches.tolist()}, {"symmetry"})
        in_plane = mesh.points[mesh.triangles_of("symmetry")]
        self.assertEqual(in_plane[:, :, 1].min(), in_plane[:, :, 1].max())

    @needs_h5py
    def test_are_the_same_in_all_formats(self):
        wanted = arrays_of(tetfarm.read_mesh("out/wing.vtkhdf"))
        for form in FORMS[1:]:
            found = arrays_of(tetfarm.read_mesh(f"out/wing.{form}"))
            for name, values in wanted.items():
                if name in ("triangles", "quads"):  # turned round, they begin at their first node again
                    self.assertEqual(sorted(map(sorted, found[name])), sorted(map(sorted, values)), (form, name))
                else:
                    self.assertEqual(found[name], values, (form, name))


class OfRegions(support.InFolder):
    def test_know_the_region_of_each_tet(self):
        support.two_boxes("boxes.off")
        pathlib.Path("job.toml").write_text('[geometry]\nsurface = "boxes.off"\n[[region]]\nat = [0.5, 0.5, 0.4]\n'
                                            'name = "steel"\n[spacing]\ndefault = 0.4\n', encoding="utf-8")
        result = tetfarm.run("job.toml", "out", format=["vtkhdf", "lb8.ugrid"] if h5py else ["lb8.ugrid"])
        for path in result.files:
            if path.suffix in (".mapbc", ".regions"):
                continue
            mesh = tetfarm.read_mesh(path)
            self.assertEqual(mesh.region_names, ["steel", "region 2"])
            volumes = support.volumes_of(mesh, "tets")
            for region, volume in ((1, 1.0), (2, 2.0)):
                self.assertAlmostEqual(float(volumes[mesh.regions["tets"] == region].sum()), volume, delta=1e-12)


class Files(support.InFolder):
    """Of a single tet, by hand."""

    POINTS = struct.pack("<12d", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)
    FACES = ((1, 2, 3), (1, 4, 2), (1, 3, 4), (2, 4, 3))  # inwards, as UGRID has them

    def ugrid(self, counts=(4, 4, 0, 1, 0, 0, 0), faces=FACES, tet=(1, 2, 3, 4), patches=(1, 2, 2, 7)):
        numbers = [n for face in faces for n in face] + list(patches) + list(tet)
        data = struct.pack("<7i", *counts) + self.POINTS + struct.pack(f"<{len(numbers)}i", *numbers)
        pathlib.Path("one.lb8.ugrid").write_bytes(data)
        return data

    def assert_refused(self, name, what):
        with self.assertRaises(tetfarm.MeshFileError) as caught:
            tetfarm.read_mesh(name)
        self.assertIn(what, caught.exception.message)

    def test_of_others_are_turned_outwards_either_way(self):
        self.ugrid()
        inwards = tetfarm.read_mesh("one.lb8.ugrid")
        self.ugrid(faces=[face[::-1] for face in self.FACES])
        outwards = tetfarm.read_mesh("one.lb8.ugrid")
        for mesh in (inwards, outwards):
            self.assertAlmostEqual(support.enclosed_by(mesh), 1 / 6)
            self.assertAlmostEqual(support.volume_of(mesh), 1 / 6)

    def test_have_names_for_patches_that_nobody_named(self):
        self.ugrid()
        mesh = tetfarm.read_mesh("one.lb8.ugrid")
        self.assertEqual(mesh.triangle_patches.tolist(), [0, 1, 1, 6])
        self.assertEqual(mesh.patch_name(6), "patch 7")
        pathlib.Path("one.mapbc").write_text("2\n1 3000 wall of steel\n2 3000 inlet\n", encoding="utf-8")
        mesh = tetfarm.read_mesh("one.lb8.ugrid")
        self.assertEqual(mesh.patch_names, ["wall of steel", "inlet"])
        self.assertEqual(len(mesh.triangles_of("inlet")), 2)

    def test_that_are_not_as_long_as_their_counts_say_are_refused(self):
        data = self.ugrid()
        for length in (0, 20, 28, len(data) - 1):
            pathlib.Path("short.lb8.ugrid").write_bytes(data[:length])
            self.assert_refused("short.lb8.ugrid", "short.lb8.ugrid: the ")
        pathlib.Path("long.lb8.ugrid").write_bytes(data + b"x")
        self.assert_refused("long.lb8.ugrid", "the length of the file does not match its counts")
        self.ugrid(counts=(2**31 - 1, 2**31 - 1, 2**31 - 1, 2**31 - 1, 2**31 - 1, 2**31 - 1, 2**31 - 1))
        self.assert_refused("one.lb8.ugrid", "does not match its counts")
        self.ugrid(counts=(4, -4, 0, 1, 0, 0, 0))
        self.assert_refused("one.lb8.ugrid", "a count is negative")

    def test_with_nodes_that_there_are_not_are_refused(self):
        for wrong in (0, 5, -1, 2**31 - 1):
            self.ugrid(tet=(1, 2, 3, wrong))
            self.assert_refused("one.lb8.ugrid", "one of the tets has a node that does not exist")
            self.ugrid(faces=((1, 2, wrong), *self.FACES[1:]))
            self.assert_refused("one.lb8.ugrid", "one of the boundary triangles has a node that does not exist")

    def test_with_regions_that_do_not_fit_are_refused(self):
        self.ugrid()
        for text in ("1 1 2 a\n", "1 2 2 a\n", "0 1 1 a\n", "x\n", "9999999 1 1 a\n", "1 1 0 a\n"):
            pathlib.Path("one.regions").write_text(text, encoding="utf-8")
            with self.assertRaises(tetfarm.MeshFileError, msg=text):
                tetfarm.read_mesh("one.lb8.ugrid")

    def test_with_damaged_bytes_are_read_or_refused(self):
        whole = self.ugrid()
        random.seed(1)
        for _ in range(300):
            data = bytearray(whole)
            for _ in range(random.randint(1, 4)):
                data[random.randrange(len(data))] = random.randrange(256)
            pathlib.Path("damaged.lb8.ugrid").write_bytes(data)
            try:
                tetfarm.read_mesh("damaged.lb8.ugrid")
            except tetfarm.MeshFileError:
                pass

    def test_of_other_formats_and_those_that_are_not_there_are_named(self):
        pathlib.Path("mesh.su2").write_text("NDIME= 3\n", encoding="utf-8")
        self.assert_refused("mesh.su2", "meshes are read from .vtkhdf")
        self.assert_refused("nothing.vtkhdf", "no such file")


class WithoutLibraries(support.InFolder):
    """A Python in which an import fails."""

    def told_without(self, library, code):
        words = f"import sys\nsys.modules[{library!r}] = None\nimport tetfarm\n" + code
        return subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, check=False)

    def test_vtkhdf_says_how_to_install_h5py(self):
        pathlib.Path("mesh.vtkhdf").write_bytes(b"x")
        done = self.told_without("h5py", "tetfarm.read_mesh('mesh.vtkhdf')")
        self.assertIn("MissingLibraryError: VTKHDF is read with h5py, which is not there", done.stderr)
        self.assertIn("apt-get install python3-h5py", done.stderr)

    def test_meshes_say_how_to_install_numpy(self):
        pathlib.Path("mesh.lb8.ugrid").write_bytes(b"x")
        done = self.told_without("numpy", "tetfarm.read_mesh('mesh.lb8.ugrid')")
        self.assertIn("apt-get install python3-numpy", done.stderr)

    def test_jobs_run_without_numpy_and_h5py(self):
        done = self.told_without("numpy", f"print(tetfarm.run({str(support.EXAMPLE)!r}, 'out').elements > 1000)")
        self.assertEqual((done.stdout, done.returncode), ("True\n", 0), done.stderr)

    def test_a_result_is_read_from_ugrid_where_there_is_no_h5py(self):
        done = self.told_without(
            "h5py", f"print(len(tetfarm.run({str(support.EXAMPLE)!r}, 'out').read_mesh().tets) > 1000)")
        self.assertEqual((done.stdout, done.returncode), ("True\n", 0), done.stderr)


@needs_h5py
class Vtkhdf(support.InFolder):
    """Files that are changed by hand."""

    def setUp(self):
        super().setUp()
        tetfarm.run(support.EXAMPLE, "out")
        self.path = pathlib.Path("out/cube_sphere.vtkhdf")

    def assert_refused_with(self, name, change, what):
        copy = pathlib.Path(f"{name}.vtkhdf")
        copy.write_bytes(self.path.read_bytes())
        with h5py.File(copy, "r+") as file:
            change(file)
        with self.assertRaises(tetfarm.MeshFileError) as caught:
            tetfarm.read_mesh(copy)
        self.assertIn(what, caught.exception.message)

    @staticmethod
    def setting(name, index, value):
        def change(file):
            file[name][index] = value
        return change

    def test_with_wrong_numbers_are_refused(self):
        for name, index, value, what in (
                ("VTKHDF/NumberOfPoints", 0, -1, "has a wrong number"),
                ("VTKHDF/NumberOfPoints", 0, 1, "does not have the shape"),
                ("VTKHDF/NumberOfCells", 1, 1 << 39, "does not have the shape"),
                ("VTKHDF/Connectivity", 7, -1, "a node that does not exist"),
                ("VTKHDF/Connectivity", 7, 1 << 30, "a node that does not exist"),
                ("VTKHDF/Offsets", 3, 11, "the offset of a cell is wrong"),
                ("VTKHDF/Types", 3, 12, "the offset of a cell is wrong"),
                ("VTKHDF/Types", 3, 42, "cells other than"),
                ("VTKHDF/PointData/GlobalNodeId", 3, -1, "a GlobalNodeId is out of range"),
                ("VTKHDF/PointData/GlobalNodeId", 3, 1 << 40, "a GlobalNodeId is out of range")):
            with self.subTest(name=name, value=value):
                self.assert_refused_with("changed", self.setting(name, index, value), what)

    def test_without_what_they_need_are_refused(self):
        def without(name):
            def change(file):
                del file[name]
            return change

        for name, what in (("VTKHDF/Points", "has no VTKHDF/Points"), ("VTKHDF", "is not a VTKHDF file"),
                           ("VTKHDF/PointData/GlobalNodeId", "no GlobalNodeId to join them by")):
            with self.subTest(name=name):
                self.assert_refused_with("without", without(name), what)

    def test_that_declare_more_than_they_can_hold_are_refused(self):
        def change(file):
            del file["VTKHDF/Points"]
            count = 1 << 39
            file["VTKHDF/NumberOfPoints"][0] += count - file["VTKHDF/NumberOfPoints"][:].sum()
            file["VTKHDF"].create_dataset("Points", (count, 3), dtype="f8", chunks=(65536, 3))

        self.assert_refused_with("large", change, "cannot be in a file of")

    def test_that_are_no_hdf5_are_refused(self):
        pathlib.Path("text.vtkhdf").write_text("no HDF5", encoding="utf-8")
        with self.assertRaises(tetfarm.MeshFileError):
            tetfarm.read_mesh("text.vtkhdf")
        pathlib.Path("half.vtkhdf").write_bytes(self.path.read_bytes()[:3000])
        with self.assertRaises(tetfarm.MeshFileError):
            tetfarm.read_mesh("half.vtkhdf")


if __name__ == "__main__":
    support.main()
