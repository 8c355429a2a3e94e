#!/usr/bin/env python3
"""The examples of docs/python.md run, one after the other, and say what they are said to; the page tells of every name."""

import ast
import contextlib
import inspect
import io
import os
import pathlib
import re
import subprocess

import support
import tetfarm

PAGE = (support.ROOT / "docs/python.md").read_text(encoding="utf-8")


class Page(support.InFolder):
    def test_has_examples_that_run(self):
        support.shape("wing", "wing.stl", 0.2)
        farm = support.Farm(self.folder)
        self.addCleanup(farm.close)
        os.environ["TETFARM_COORDINATOR"] = farm.address
        self.addCleanup(os.environ.pop, "TETFARM_COORDINATOR")
        blocks = re.findall(r"^```python\n(.*?)^```$", PAGE, re.DOTALL | re.MULTILINE)
        self.assertGreaterEqual(len(blocks), 7)
        names, printed = {}, io.StringIO()
        for block in blocks:
            with self.subTest(block=block), contextlib.redirect_stdout(printed):
                exec(compile(block, "docs/python.md", "exec"), names)  # noqa: S102
        for wanted in ("unknown option `--sise`; did you mean `--size`?", "see `tetfarm run --help`", "'symmetry', 'wing'"):
            self.assertIn(wanted, printed.getvalue())
        self.assertAlmostEqual(float(names["volumes"].sum()), support.enclosed_by(names["mesh"]), places=6)
        self.assertIn(("job-2", "cancelled"), [(job["job"], job["state"]) for job in tetfarm.jobs()])

    def test_tells_of_all_that_the_module_has(self):
        for name in tetfarm.__all__:
            if name in ("Mesh", "Result", "Progress", "find_program"):  # told of by what they have
                continue
            self.assertRegex(PAGE, rf"`{name}\b", name)
        for kind in (tetfarm.Mesh, tetfarm.Progress):
            for name in kind.__dataclass_fields__:
                if name not in ("state", "job"):
                    self.assertRegex(PAGE, rf"`{name}\b", name)


class Module(support.InFolder):
    def test_has_the_version_of_the_program(self):
        said = subprocess.run([os.environ["TETFARM"], "--version"], capture_output=True, text=True, check=True).stdout
        version = said.split()[1]
        self.assertEqual(tetfarm.__version__, version)
        text = (support.ROOT / "python/pyproject.toml").read_text(encoding="utf-8")
        self.assertIn(f'version = "{version}"', text)

    def test_is_typed_and_explained(self):
        folder = pathlib.Path(tetfarm.__file__).parent
        self.assertTrue((folder / "py.typed").is_file())
        for name in tetfarm.__all__:
            self.assertTrue(inspect.getdoc(getattr(tetfarm, name)), name)
        for name in ("run", "submit", "wait", "status", "jobs", "cancel", "read_mesh"):
            signature = inspect.signature(getattr(tetfarm, name))
            self.assertIsNot(signature.return_annotation, inspect.Signature.empty, name)
            for parameter in signature.parameters.values():
                self.assertIsNot(parameter.annotation, inspect.Parameter.empty, f"{name}: {parameter}")

    def test_is_python_3_9(self):
        for path in pathlib.Path(tetfarm.__file__).parent.glob("*.py"):
            ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 9))


if __name__ == "__main__":
    support.main()
