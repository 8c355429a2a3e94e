#!/usr/bin/env python3
"""How calls end that do not end well: killed programs, Ctrl-C, time limits, and programs that say what nobody expects."""

import os
import pathlib
import pickle
import shutil
import signal
import subprocess
import sys
import time
from unittest import mock

import support
import tetfarm
from tetfarm import program

LONG = dict(size=0.015, workers=1, subdomains=1, max_elements=100_000_000)  # a minute and more
SCRIPT = """
import sys, tetfarm
print("begun", flush=True)
try:
    tetfarm.run(sys.argv[1], "out", size=0.015, workers=1, subdomains=1, max_elements=100_000_000, grace=float(sys.argv[2]),
                on_progress=lambda progress: print(progress.stage, flush=True))
except KeyboardInterrupt:
    print("interrupted", flush=True)
    sys.exit(9)
"""


class RealProgram(support.InFolder):
    def start(self, grace=0.2):
        """Another Python that runs a long job, once its meshing has begun."""
        child = subprocess.Popen([sys.executable, "-c", SCRIPT, str(support.SURFACE), str(grace)], stdout=subprocess.PIPE,
                                 text=True)
        self.addCleanup(self.end, child)
        for line in child.stdout:
            if line.strip() == "mesh":
                return child
        self.fail("it ended before it meshed")

    def end(self, child):
        child.kill()
        child.wait()
        child.stdout.close()
        for process in support.processes_in(self.folder):
            os.kill(process, signal.SIGKILL)
        support.await_that(lambda: not support.processes_in(self.folder))

    def test_is_stopped_at_a_checkpoint_by_ctrl_c(self):
        child = self.start()
        child.send_signal(signal.SIGINT)
        said = child.stdout.read()
        self.assertEqual(child.wait(), 9)
        self.assertIn("interrupted", said)
        self.assert_nothing_runs()
        self.assertEqual([job["state"] for job in tetfarm.jobs(store="out")], ["stopped"])

    def test_goes_on_after_ctrl_c(self):
        child = self.start()
        child.send_signal(signal.SIGINT)
        child.wait()
        again = tetfarm.run(support.SURFACE, "out", size=0.08)
        self.assertGreater(again.elements, 0)

    def test_hands_back_its_tasks_at_once_after_a_second_ctrl_c(self):
        child = self.start(grace=60)
        begun = time.monotonic()
        child.send_signal(signal.SIGINT)
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        child.wait()
        self.assertLess(time.monotonic() - begun, 30, "the grace of 60 s is not waited for")
        self.assert_nothing_runs()

    def test_stops_too_when_python_is_killed(self):
        if shutil.which("setpriv") is None:
            self.skipTest("no setpriv")
        child = self.start()
        child.kill()
        child.wait()
        self.assert_nothing_runs()

    def test_that_is_killed_is_an_error_that_names_the_signal(self):
        def kill(progress):
            if progress.stage == "mesh":
                for process, words in support.processes_in(self.folder).items():
                    if " run " in words:
                        os.kill(process, signal.SIGKILL)

        with self.assertRaises(tetfarm.ProgramDiedError) as caught:
            tetfarm.run(support.SURFACE, "out", on_progress=kill, **LONG)
        self.assertEqual(caught.exception.exit_code, -signal.SIGKILL)
        self.assertIn("SIGKILL", caught.exception.message)

    def test_that_somebody_stops_is_an_error_of_its_own(self):
        def stop(progress):
            if progress.stage == "mesh":
                for process, words in support.processes_in(self.folder).items():
                    if " run " in words:
                        os.kill(process, signal.SIGTERM)

        with self.assertRaises(tetfarm.StoppedError) as caught:
            tetfarm.run(support.SURFACE, "out", on_progress=stop, grace=0, **LONG)
        self.assertEqual(caught.exception.exit_code, 75)

    def test_ends_at_its_time_limit(self):
        begun = time.monotonic()
        with self.assertRaises(tetfarm.TimeLimitError):
            tetfarm.run(support.SURFACE, "out", time_limit=1.5, grace=0, **LONG)
        self.assertLess(time.monotonic() - begun, 15)
        self.assert_nothing_runs()

    def test_ends_when_a_callback_raises(self):
        class Enough(Exception):
            pass

        def enough(_):
            raise Enough

        with self.assertRaises(Enough):
            tetfarm.run(support.SURFACE, "out", on_progress=enough, grace=0, **LONG)
        self.assert_nothing_runs()


class OtherProgram(support.InFolder):
    """A program that says what tetfarm would not."""

    def run_with(self, script, **options):
        with support.program_that(script, self.folder):
            return tetfarm.run("wing.stl", "out", **options)

    def assert_raises(self, kind, script, **options):
        with self.assertRaises(kind) as caught:
            self.run_with(script, **options)
        self.assert_nothing_runs()
        return caught.exception

    def test_that_ends_without_a_word_is_an_error(self):
        error = self.assert_raises(tetfarm.ProgramDiedError, "exit 127")
        self.assertEqual(error.exit_code, 127)

    def test_that_ends_without_its_end_is_quoted(self):
        error = self.assert_raises(tetfarm.ProgramDiedError, "echo 'libfoo.so: not found' >&2; exit 127")
        self.assertIn("libfoo.so: not found", error.message)

    def test_that_ends_well_without_a_result_is_an_error(self):
        end = '{"type":"end","version":1,"state":"done","exit_code":0}'
        self.assert_raises(tetfarm.ProtocolError, "exit 0")
        self.assert_raises(tetfarm.ProtocolError, f"echo '{end}' >&2")

    def test_that_dies_after_its_end_is_an_error(self):
        end = '{"type":"end","version":1,"state":"done","exit_code":0}'
        error = self.assert_raises(tetfarm.ProgramDiedError,
                                   f"echo '{{\"type\":\"result\"}}'; echo '{end}' >&2; kill -SEGV $$")
        self.assertIn("SIGSEGV", error.message)

    def test_whose_text_is_no_json_is_heard_all_the_same(self):
        told = []
        result = self.run_with('echo "a warning" >&2; echo \'{"type":"result","job":"job-1","files":[]}\'',
                               on_message=told.append)
        self.assertEqual((result.job, told), ("job-1", ["a warning"]))

    def test_of_another_version_is_refused_and_ended(self):
        error = self.assert_raises(tetfarm.ProtocolError, 'echo \'{"type":"progress","version":2}\' >&2; exec sleep 60')
        self.assertIn("version 2", error.message)

    def test_whose_numbers_are_none_is_refused(self):
        self.assert_raises(tetfarm.ProtocolError,
                           'echo \'{"type":"progress","version":1,"share":"much"}\' >&2; exec sleep 60',
                           on_progress=lambda progress: None)

    def test_that_says_a_line_without_end_is_ended(self):
        error = self.assert_raises(tetfarm.ProtocolError, "tr '\\0' x </dev/zero >&2")
        self.assertIn("longer than", error.message)

    def test_whose_json_is_nested_without_end_is_no_json(self):
        self.assert_raises(tetfarm.ProtocolError, "head -c 500000 /dev/zero | tr '\\0' '[' >&2")

    def test_that_ends_does_not_have_to_close_its_output(self):
        begun = time.monotonic()
        result = self.run_with('sleep 30 & echo $! >sleeper; echo \'{"type":"result","job":"j","files":[]}\'')
        self.assertEqual(result.job, "j")
        self.assertLess(time.monotonic() - begun, 10)
        os.kill(int(pathlib.Path("sleeper").read_text(encoding="utf-8")), signal.SIGKILL)

    def test_that_does_not_want_to_end_is_killed(self):
        with mock.patch.object(program, "_TO_END", 0.2), mock.patch.object(program, "_IN_A_HURRY", 0.2):
            self.assert_raises(tetfarm.TimeLimitError, "trap '' TERM; while :; do sleep 0.1; done", time_limit=0.5,
                               grace=0)

    def test_with_a_full_pipe_ends_all_the_same(self):
        self.assert_raises(tetfarm.TimeLimitError,
                           "trap 'head -c 1000000 /dev/zero; exit 75' TERM; while :; do sleep 0.1; done",
                           time_limit=0.5)

    def test_that_is_not_there_is_named(self):
        before = os.environ["TETFARM"]
        self.addCleanup(os.environ.__setitem__, "TETFARM", before)
        os.environ["TETFARM"] = str(self.folder / "nothing")
        with self.assertRaises(tetfarm.ProgramNotFoundError) as caught:
            tetfarm.run("wing.stl")
        self.assertIn("$TETFARM is", caught.exception.message)
        del os.environ["TETFARM"]
        with mock.patch.dict(os.environ, {"PATH": str(self.folder)}):
            with self.assertRaises(tetfarm.ProgramNotFoundError):
                tetfarm.run("wing.stl")

    def test_is_taken_from_the_path_where_nothing_names_it(self):
        with support.program_that("echo '{\"type\":\"job\",\"job\":\"job-5\"}'", self.folder) as path:
            path.rename(self.folder / "tetfarm")
            del os.environ["TETFARM"]
            with mock.patch.dict(os.environ, {"PATH": f"{self.folder}:{os.environ['PATH']}"}):
                self.assertEqual(tetfarm.status("job-5")["job"], "job-5")

    def test_errors_go_from_process_to_process(self):
        error = pickle.loads(pickle.dumps(tetfarm.UsageError("what", help="help", exit_code=2)))
        self.assertEqual((type(error), error.message, error.help, error.exit_code),
                         (tetfarm.UsageError, "what", "help", 2))
        self.assertEqual(str(error), "what\nhelp: help")


if __name__ == "__main__":
    support.main()
