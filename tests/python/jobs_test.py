#!/usr/bin/env python3
"""Jobs through the module and the built program, on this machine and on a farm."""

import os
import pathlib
import unittest

import support
import tetfarm
from tetfarm.program import option_words, path_word


class Run(support.InFolder):
    def test_gives_the_mesh_whose_figures_the_result_has(self):
        result = tetfarm.run(support.EXAMPLE, "out")
        self.assertEqual(sorted(path.name for path in result.files),
                         ["cube_sphere.lb8.ugrid", "cube_sphere.mapbc", "cube_sphere.vtkhdf"])
        for path in result.files:
            if path.suffix == ".mapbc":
                continue
            mesh = tetfarm.read_mesh(path)
            self.assertEqual(len(mesh.tets), result.elements)
            self.assertEqual(len(mesh.points), result.nodes)
            self.assertEqual(len(mesh.triangles), result.figures["boundary_triangles"])
            self.assertAlmostEqual(support.volume_of(mesh), result.volume, delta=1e-12)
            self.assertAlmostEqual(support.enclosed_by(mesh), result.volume, delta=1e-12)
            self.assertGreater(support.volumes_of(mesh, "tets").min(), 0)
            self.assertEqual(support.unmatched_faces(mesh), 0)

    def test_tells_its_progress_which_never_falls(self):
        told = []
        tetfarm.run(support.EXAMPLE, "out", on_progress=told.append)
        shares = [progress.share for progress in told]
        self.assertTrue(shares)
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(set(progress.stage for progress in told),
                             {"inspect", "decompose", "mesh", "order", "extract", "cosmetic", "number", "write", "assemble"})
        self.assertTrue(all(progress.line["tasks"]["total"] >= 0 for progress in told))

    def test_tells_what_people_would_have_read(self):
        told = []
        tetfarm.run(support.SURFACE, "out", frequency="300MHz", on_message=told.append)
        self.assertIn("to a wavelength", " ".join(told))

    def test_takes_options_as_keywords(self):
        coarse = tetfarm.run(support.SURFACE, "coarse", workers=1)
        fine = tetfarm.run(support.SURFACE, "fine", workers=1, size=0.06, growth=0.2, subdomains=2,
                           format=["lb8.ugrid", "su2"])
        self.assertGreater(fine.elements, coarse.elements)
        self.assertEqual(fine.figures["subdomains"], 2)
        self.assertTrue(any(path.suffix == ".su2" for path in fine.files))

    def test_goes_on_where_it_was(self):
        first = tetfarm.run(support.EXAMPLE, "out")
        again = tetfarm.run(support.EXAMPLE, "out")
        self.assertEqual((again.digest, again.job), (first.digest, first.job))

    def test_meshes_a_surface_whose_name_looks_like_an_option(self):
        pathlib.Path("--help.msh").write_bytes(support.SURFACE.read_bytes())
        self.assertGreater(tetfarm.run("--help.msh", "-o").elements, 1000)
        self.assertTrue(pathlib.Path("-o").is_dir())

    def test_refuses_an_option_that_there_is_not(self):
        with self.assertRaises(tetfarm.UsageError) as caught:
            tetfarm.run(support.SURFACE, "out", sise=0.1)
        self.assertEqual(caught.exception.exit_code, 2)
        self.assertIn("did you mean `--size`", caught.exception.message)
        self.assertIn("tetfarm run --help", caught.exception.help)

    def test_refuses_options_that_are_its_own(self):
        for name in ("json", "progress"):
            with self.assertRaises(TypeError):
                tetfarm.run(support.SURFACE, "out", **{name: True})

    def test_says_that_a_surface_is_not_there(self):
        with self.assertRaises(tetfarm.NotFoundError) as caught:
            tetfarm.run("nothing.stl")
        self.assertEqual(caught.exception.exit_code, 5)
        self.assertIn("nothing.stl", caught.exception.message)

    def test_says_where_a_surface_is_open(self):
        support.open_cube("open.off")
        with self.assertRaises(tetfarm.GeometryError) as caught:
            tetfarm.run("open.off", "out")
        self.assertEqual(caught.exception.exit_code, 3)
        self.assertIn("repair the input", caught.exception.help)

    def test_gives_the_mesh_with_the_error_where_it_is_below_a_gate(self):
        pathlib.Path("strict.toml").write_text(
            f'[geometry]\nsurface = "{support.SURFACE}"\n[quality]\nmin_dihedral = 60\n', encoding="utf-8")
        with self.assertRaises(tetfarm.GateError) as caught:
            tetfarm.run("strict.toml", "out", format="lb8.ugrid")
        self.assertEqual(caught.exception.exit_code, 4)
        self.assertIn("min_dihedral", caught.exception.message)
        self.assertEqual(len(caught.exception.result.read_mesh().tets), caught.exception.result.elements)

    def test_is_told_of_by_status_and_jobs_in_its_folder(self):
        result = tetfarm.run(support.EXAMPLE, "out")
        self.assertEqual(tetfarm.status(result.job, store="out")["state"], "done")
        self.assertEqual([job["elements"] for job in tetfarm.jobs(store="out")], [result.elements])
        with self.assertRaises(tetfarm.NotFoundError):
            tetfarm.status("job-99", store="out")


class Farm(support.InFolder):
    def setUp(self):
        super().setUp()
        self.farm = support.Farm(self.folder)
        self.addCleanup(self.farm.close)

    def test_gives_the_mesh_that_a_run_gives(self):
        here = tetfarm.run(support.EXAMPLE, "here")
        job = tetfarm.submit(support.EXAMPLE, connect=self.farm.address)
        told = []
        result = tetfarm.wait(job, "there", connect=self.farm.address, on_progress=told.append)
        self.assertEqual(result.digest, here.digest)
        self.assertEqual(len(result.read_mesh().tets), here.elements)
        self.assertEqual(tetfarm.status(job, connect=self.farm.address)["state"], "done")

    def test_ends_a_job_that_is_cancelled(self):
        job = tetfarm.submit(support.SURFACE, connect=self.farm.address, size=0.02)
        tetfarm.cancel(job, connect=self.farm.address)
        self.assertEqual([line["state"] for line in tetfarm.jobs(connect=self.farm.address)], ["cancelled"])
        with self.assertRaises(tetfarm.TetfarmError) as caught:
            tetfarm.wait(job, connect=self.farm.address)
        self.assertEqual((caught.exception.exit_code, caught.exception.message), (1, "the job was cancelled"))

    def test_lets_a_job_go_on_that_nobody_waits_for_any_more(self):
        job = tetfarm.submit(support.SURFACE, connect=self.farm.address, size=0.03)
        with self.assertRaises(tetfarm.TimeLimitError):
            tetfarm.wait(job, connect=self.farm.address, time_limit=0.5)
        self.assertEqual(tetfarm.status(job, connect=self.farm.address)["state"], "running")

    def test_is_found_by_the_environment(self):
        os.environ["TETFARM_COORDINATOR"] = self.farm.address
        self.addCleanup(os.environ.pop, "TETFARM_COORDINATOR")
        self.assertEqual(tetfarm.jobs(), [])

    def test_that_nobody_runs_is_said_to_be_missing(self):
        self.farm.close()
        with self.assertRaises(tetfarm.NotFoundError) as caught:
            tetfarm.submit(support.SURFACE, connect=self.farm.address, timeout=0.5)
        self.assertIn("no coordinator answers", caught.exception.message)


class Words(unittest.TestCase):
    def test_of_options_are_those_of_the_command_line(self):
        self.assertEqual(option_words({"outer_size": 2.5, "force": True, "remesh": False, "keep": None,
                                       "layers": ["a:count=1", "b:count=2"], "workers": 3}),
                         ["--outer-size=2.5", "--force", "--layers=a:count=1", "--layers=b:count=2", "--workers=3"])

    def test_of_numbers_have_all_digits(self):
        self.assertEqual(option_words({"size": 0.1 + 0.2}), ["--size=0.30000000000000004"])
        import numpy
        self.assertEqual(option_words({"size": numpy.float64(0.5), "workers": numpy.int32(2)}),
                         ["--size=0.5", "--workers=2"])

    def test_cannot_be_anything_else(self):
        for value in ({}, object(), b"bytes", "a\0b", [["a"]]):
            with self.assertRaises(TypeError):
                option_words({"size": value})
        with self.assertRaises(TypeError):
            path_word("")

    def test_of_paths_are_never_options(self):
        self.assertEqual(path_word("-x.stl"), "./-x.stl")


if __name__ == "__main__":
    support.main()
