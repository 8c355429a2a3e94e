"""Runs the program `tetfarm`: finds it, puts its command line together, and reads what it says while it runs.

Everything is bounded: the length of a line, what is kept of all lines, and the time that a program is waited for once it
was told to stop.
"""

from __future__ import annotations

import json
import os
import selectors
import shutil
import signal
import subprocess
import time
from dataclasses import dataclass, field
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Union

from .errors import ProgramDiedError, ProgramNotFoundError, ProtocolError, TimeLimitError, error_of

Scalar = Union[None, bool, int, float, str, "os.PathLike[str]"]
Option = Union[Scalar, Sequence[Scalar]]

#: Of the documented lines of `--progress json`.
PROTOCOL_VERSION = 1

_LONGEST_LINE = 1 << 20  # of progress
_LONGEST_RESULT = 1 << 28  # a job may have a million sub-domains of which something is said
_LAST_WORDS = 4096
_GRACE = 5.0  # the program's own, where `grace` is not given
_TO_END = 30.0  # beyond its grace
_IN_A_HURRY = 10.0
_SILENCE_AFTER_END = 2.0  # of processes that outlive it and hold its output open


def find_program() -> str:
    """The path of the program: $TETFARM, else the first `tetfarm` on the PATH."""
    named = os.environ.get("TETFARM", "")
    found = shutil.which(named or "tetfarm")
    if found is None:
        raise ProgramNotFoundError(
            f"$TETFARM is {named}, which is no program" if named else "there is no program tetfarm on the PATH",
            help="install it, or set TETFARM to its path")
    return os.path.abspath(found)


def path_word(path: "Union[str, os.PathLike[str]]") -> str:
    """A path as a word of a command line, which nobody takes for an option."""
    word = os.fspath(path)
    if not isinstance(word, str) or not word or "\0" in word:
        raise TypeError("a path is a text that is not empty")
    return os.path.join(".", word) if word.startswith("-") else word


def option_words(options: Mapping[str, Option]) -> List[str]:
    """`outer_size=2.5` as `--outer-size=2.5`, True as the option alone, a list as the option again and again.

    What is None or False is left out. The program knows which options there are.
    """
    words: List[str] = []
    for name, value in options.items():
        if not name.isidentifier():
            raise TypeError(f"{name!r} is no name of an option")
        flag = "--" + name.rstrip("_").replace("_", "-")
        for one in value if isinstance(value, (list, tuple)) else [value]:
            words.extend(_words_of(flag, one))
    return words


def _words_of(flag: str, value: Any) -> List[str]:
    if value is None or value is False:
        return []
    if value is True:
        return [flag]
    if isinstance(value, float):
        return [f"{flag}={value!r}"]  # all digits
    if hasattr(value, "item") and not isinstance(value, (str, os.PathLike)):
        return _words_of(flag, value.item())  # a number of numpy
    if not isinstance(value, (int, str, os.PathLike)):
        raise TypeError(f"{flag} cannot be a {type(value).__name__}")
    word = str(os.fspath(value)) if isinstance(value, os.PathLike) else str(value)
    if "\0" in word:
        raise TypeError(f"{flag} cannot hold a NUL")
    return [f"{flag}={word}"]


def parse_object(line: bytes) -> Optional[Dict[str, Any]]:
    """The JSON object of a line, None where it is none."""
    try:
        found = json.loads(line.decode("utf-8"))
    except (ValueError, RecursionError):
        return None
    return found if isinstance(found, dict) else None


@dataclass
class Ended:
    """What is left of a program that has ended."""

    code: int
    """Of the process; negative: the signal that killed it."""
    output: List[Dict[str, Any]]
    """The objects on its standard output."""
    end: Optional[Dict[str, Any]] = None
    """The last line of `--progress json`."""
    last_words: str = ""
    """The end of what it said for people."""

    def raise_for_error(self) -> None:
        """The exception for what went wrong, if anything did."""
        if self.end is not None and self.code >= 0:
            if self.code != 0 and self.end.get("state") != "done":
                raise error_of(self.code, str(self.end.get("message", "")) or _died(self.code, self.last_words),
                               str(self.end.get("help", "")))
            return
        if self.code > 0:
            message, help = self._complaint()
            if message:
                raise error_of(self.code, message, help)
        if self.code != 0 or self.end is not None:
            raise ProgramDiedError(_died(self.code, self.last_words), exit_code=self.code)

    def _complaint(self) -> "tuple[str, str]":
        """Of a command without progress: {"type":"error"} on standard output, and `help: …` on the other."""
        message = next((str(line.get("message", "")) for line in self.output if line.get("type") == "error"), "")
        lines = self.last_words.splitlines()
        help = next((line[len("help: "):] for line in reversed(lines) if line.startswith("help: ")), "")
        if not message:
            message = next((line[len("error: "):] for line in reversed(lines) if line.startswith("error: ")), "")
        return message, help

    def last(self, kind: str) -> Optional[Dict[str, Any]]:
        """The last object of a type on its standard output."""
        return next((line for line in reversed(self.output) if line.get("type") == kind), None)


def _died(code: int, last_words: str) -> str:
    if code < 0:
        try:
            how = f"was killed by {signal.Signals(-code).name}"
        except ValueError:
            how = f"was killed by signal {-code}"
    else:
        how = f"ended with exit code {code} and did not say why"
    return f"tetfarm {how}" + (f": {last_words.strip()}" if last_words.strip() else "")


@dataclass
class _Lines:
    """Takes bytes as they come and gives out whole lines."""

    longest: int
    rest: bytearray = field(default_factory=bytearray)

    def add(self, data: bytes) -> Iterator[bytes]:
        searched = len(self.rest)
        self.rest += data
        end = self.rest.find(b"\n", searched)
        while end >= 0:
            line = bytes(self.rest[:end])
            del self.rest[:end + 1]
            yield line
            end = self.rest.find(b"\n")
        if len(self.rest) > self.longest:
            raise ProtocolError(f"a line of what tetfarm says is longer than {self.longest} bytes")

    def finish(self) -> Iterator[bytes]:
        if self.rest:
            yield bytes(self.rest)
            self.rest.clear()


class Conversation:
    """One program while it runs.

    Its session is its own, so that Ctrl-C reaches Python alone, which tells the program to stop; and it is told so when
    Python dies, where there is setpriv(1).
    """

    def __init__(self, words: Sequence[str], *, on_line: Callable[[Dict[str, Any]], None],
                 on_text: Callable[[str], None], time_limit: Optional[float], grace: float = _GRACE,
                 tells_progress: bool = True) -> None:
        self._tells_progress = tells_progress
        self._on_line, self._on_text, self._grace = on_line, on_text, grace
        self._deadline = None if time_limit is None else time.monotonic() + time_limit
        self._time_limit = time_limit
        self._last_words = ""
        self._end: Optional[Dict[str, Any]] = None
        self._output: List[Dict[str, Any]] = []
        self._output_size = 0
        program = find_program()
        guard = shutil.which("setpriv")
        before = [guard, "--pdeathsig", "TERM"] if guard else []
        try:
            self._child = subprocess.Popen([*before, program, *words], stdin=subprocess.DEVNULL,
                                           stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
        except OSError as error:
            raise ProgramNotFoundError(f"{program}: {error.strerror}", help="install it, or set TETFARM") from error
        out, err = self._child.stdout, self._child.stderr
        assert out is not None and err is not None  # they were asked for
        self._out, self._err = out, err

    def run(self) -> Ended:
        """Until the program has ended. Whatever is raised meanwhile, by a callback or Ctrl-C, ends the program first."""
        try:
            self._read()
            code = self._child.wait()
        except BaseException:
            self._stop()
            raise
        finally:
            self._out.close()
            self._err.close()
        return Ended(code, self._output, self._end, self._last_words)

    def _read(self) -> None:
        takers = {self._out: (_Lines(_LONGEST_RESULT), self._take_output),
                  self._err: (_Lines(_LONGEST_LINE), self._take_progress)}
        with selectors.DefaultSelector() as selector:
            for pipe, taker in takers.items():
                selector.register(pipe, selectors.EVENT_READ, taker)
            ended = None
            while selector.get_map():
                ready = selector.select(self._patience(ended))
                for key, _ in ready:
                    lines, take = key.data
                    data = os.read(key.fd, 1 << 16)
                    for line in lines.add(data) if data else lines.finish():
                        take(line)
                    if not data:
                        selector.unregister(key.fileobj)
                now = time.monotonic()
                if self._child.poll() is not None:
                    ended = ended or now
                    if not ready and now - ended > _SILENCE_AFTER_END:
                        break
                elif self._deadline is not None and now > self._deadline:
                    raise TimeLimitError(f"tetfarm did not end within {self._time_limit} s",
                                         help="the same call goes on from there")
            for lines, take in takers.values():
                for line in lines.finish():
                    take(line)

    def _patience(self, ended: Optional[float]) -> float:
        """How long to wait for the next bytes."""
        if ended is not None or self._deadline is None:
            return 0.5
        return min(0.5, max(0.0, self._deadline - time.monotonic()) + 0.001)

    def _take_output(self, line: bytes) -> None:
        self._output_size += len(line)
        if self._output_size > _LONGEST_RESULT:
            raise ProtocolError(f"tetfarm says more than {_LONGEST_RESULT} bytes")
        found = parse_object(line)
        if found is None:
            self._hear(line)
        else:
            self._output.append(found)

    def _take_progress(self, line: bytes) -> None:
        found = parse_object(line) if self._tells_progress else None
        if found is None:
            self._hear(line)
            return
        if found.get("version") != PROTOCOL_VERSION:
            raise ProtocolError(f"tetfarm tells its progress in version {found.get('version')!r}, and this module "
                                f"understands {PROTOCOL_VERSION}", help="install the two of one version")
        if found.get("type") == "end":
            self._end = found
        elif found.get("type") == "message":
            self._hear(str(found.get("text", "")).encode())
        else:
            self._on_line(found)

    def _hear(self, line: bytes) -> None:
        """Text for people, or what is no JSON, as of a dynamic linker."""
        text = line.decode("utf-8", "replace").rstrip()
        if not text:
            return
        self._last_words = (self._last_words + text + "\n")[-_LAST_WORDS:]
        self._on_text(text)

    def _stop(self) -> None:
        """Told once, it hands back its tasks after its grace; told twice, by a second Ctrl-C, at once; then it is killed."""
        for patience in (self._grace + _TO_END, _IN_A_HURRY):
            if self._child.poll() is not None:
                return
            self._child.terminate()
            try:
                self._drain_until_ended(patience)
            except KeyboardInterrupt:
                continue
        if self._child.poll() is None:
            os.killpg(self._child.pid, signal.SIGKILL)  # with what it has started
            self._child.wait()

    def _drain_until_ended(self, patience: float) -> None:
        """What it still says is not heard, but a full pipe must not keep it from ending."""
        until = time.monotonic() + patience
        with selectors.DefaultSelector() as selector:
            for pipe in (self._out, self._err):
                selector.register(pipe, selectors.EVENT_READ)
            while self._child.poll() is None and time.monotonic() < until:
                if not selector.get_map():
                    time.sleep(0.02)
                for key, _ in selector.select(0.05) if selector.get_map() else []:
                    if not os.read(key.fd, 1 << 16):
                        selector.unregister(key.fileobj)


def ask(words: Sequence[str], time_limit: Optional[float] = None) -> Ended:
    """A command without progress: what it printed, or the exception for what went wrong."""
    def ignore(_: Any) -> None:
        pass

    ended = Conversation(words, on_line=ignore, on_text=ignore, time_limit=time_limit, tells_progress=False).run()
    ended.raise_for_error()
    return ended
