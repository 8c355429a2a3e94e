"""Jobs: meshed here with `run`, or handed to a farm with `submit`, `wait`, `status`, `cancel` and `jobs`.

Each function is the command of the program of that name, and takes its options as keywords: `outer_size=2` is
`--outer-size 2`. What they mean is said in `tetfarm man run`, and so on.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional, Tuple, Union

from .errors import GateError, MeshFileError, MissingLibraryError, ProtocolError
from .program import Conversation, Ended, Option, ask, option_words, path_word

if TYPE_CHECKING:
    from .meshes import Mesh

PathText = Union[str, "os.PathLike[str]"]
_TAKEN = ("json", "progress", "output", "connect", "o", "j")


@dataclass(frozen=True)
class Progress:
    """How far a job is. `line` is all that the program tells; the rest is what most need of it."""

    job: str
    state: str
    """`running`, or `stuck` while the disk has no room."""
    stage: str
    """The earliest kind of task of which some are left: `inspect`, `decompose`, `mesh`, ..."""
    share: float
    """How much of the job is done, 0 to 1. It never falls."""
    elements: int
    """In the sub-domains that are meshed."""
    estimated_elements: float
    """Of the whole job; 0: not known yet."""
    workers: int
    eta_seconds: Optional[float]
    """Until the sub-domains are meshed; None: not known."""
    line: Mapping[str, Any] = field(repr=False, default_factory=dict)


OnProgress = Callable[[Progress], None]
OnMessage = Callable[[str], None]


@dataclass(frozen=True)
class Result:
    """A job that is done. `figures` has every key of the result line of `tetfarm run --json`."""

    job: str
    files: Tuple[Path, ...]
    figures: Mapping[str, Any] = field(repr=False, default_factory=dict)

    @property
    def elements(self) -> int:
        """All cells of the mesh."""
        return int(self.figures["elements"])

    @property
    def nodes(self) -> int:
        return int(self.figures["nodes"])

    @property
    def volume(self) -> float:
        return float(self.figures["volume"])

    @property
    def digest(self) -> str:
        """Names the mesh itself, whatever the format of its files."""
        return str(self.figures["digest"])

    def read_mesh(self) -> "Mesh":
        """The mesh, from whichever of the files can be read here."""
        from .meshes import can_read, read_mesh

        readable = [path for path in self.files if can_read(path)]
        if not readable:
            raise MeshFileError("none of the files of the result can be read as a mesh",
                                help="ask for one: format='lb8.ugrid', and for a job of a farm wait(job, output=DIR)")
        # UGRID before VTKHDF, which needs a library more.
        readable.sort(key=lambda path: not path.name.endswith(".ugrid"))
        for path in readable[:-1]:
            try:
                return read_mesh(path)
            except MissingLibraryError:
                continue
        return read_mesh(readable[-1])


def _number(line: Mapping[str, Any], key: str) -> float:
    value = line.get(key, 0)
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise ProtocolError(f"tetfarm tells {key} as {value!r}, which is no number")
    return value


def _progress_of(line: Mapping[str, Any]) -> Progress:
    return Progress(job=str(line.get("job", "")), state=str(line.get("state", "")), stage=str(line.get("stage", "")),
                    share=float(_number(line, "share")), elements=int(_number(line, "elements")),
                    estimated_elements=float(_number(line, "estimated_elements")),
                    workers=int(_number(line, "workers")),
                    eta_seconds=None if line.get("eta_seconds") is None else float(_number(line, "eta_seconds")),
                    line=dict(line))


def _checked(options: Mapping[str, Option], connect: Optional[str] = None) -> List[str]:
    for name in _TAKEN:
        if name in options:
            raise TypeError(f"{name} is no option of this call")
    return option_words({"connect": connect, **options})


def _grace_of(options: Mapping[str, Option]) -> float:
    grace = options.get("grace")
    return float(grace) if isinstance(grace, (int, float)) and 0 <= grace < 1e6 else 5.0


def _converse(words: List[str], on_progress: Optional[OnProgress], on_message: Optional[OnMessage],
              time_limit: Optional[float], grace: float = 5.0) -> Ended:
    def hear(line: Dict[str, Any]) -> None:
        if line.get("type") == "progress" and on_progress is not None:
            on_progress(_progress_of(line))

    def read(text: str) -> None:
        if on_message is not None:
            on_message(text)

    ended = Conversation([*words, "--json", "--progress=json"], on_line=hear, on_text=read, time_limit=time_limit,
                         grace=grace).run()
    ended.raise_for_error()
    return ended


def _result_of(ended: Ended) -> Result:
    figures = ended.last("result") or ended.last("loop")
    if figures is None or not isinstance(figures.get("files", []), list):
        raise ProtocolError("tetfarm ended well, but told no result")
    result = Result(str(figures.get("job", "")), tuple(Path(str(name)) for name in figures.get("files", [])), figures)
    if ended.code != 0:
        raise _below_gate(result)
    return result


def _below_gate(result: Result) -> GateError:
    gates = result.figures.get("gates")
    failed = [gate for gate in gates if isinstance(gate, dict) and not gate.get("passed", True)] \
        if isinstance(gates, list) else []
    told = "; ".join(f"{gate.get('key')}: {gate.get('smallest_deg')} degrees, below {gate.get('limit_deg')}"
                     for gate in failed)
    error = GateError("the mesh is there, but below a gate" + (f": {told}" if told else ""),
                      help="the mesh is the `result` of this exception", exit_code=4)
    error.result = result
    return error


def run(surface_or_job: PathText, output: PathText = "out", *, on_progress: Optional[OnProgress] = None,
        on_message: Optional[OnMessage] = None, time_limit: Optional[float] = None, **options: Option) -> Result:
    """Meshes a surface, or what a job file (.toml) asks for, on this machine.

    The result lies in the folder `output`. After any interruption the same call goes on from there. `on_progress` is
    called with each line of progress, `on_message` with each line that people would have read; what they raise ends the
    run. So do Ctrl-C and, after `time_limit` seconds, TimeLimitError; both let the program stop at a checkpoint.

    >>> result = run("wing.stl", "out", size=0.1, outer="box:5", workers=4, format=["vtkhdf", "lb8.ugrid"])
    """
    words = ["run", path_word(surface_or_job), f"--output={os.fspath(output)}", *_checked(options)]
    return _result_of(_converse(words, on_progress, on_message, time_limit, _grace_of(options)))


def submit(surface_or_job: PathText, *, connect: Optional[str] = None, on_message: Optional[OnMessage] = None,
           time_limit: Optional[float] = None, **options: Option) -> str:
    """Hands a job to the coordinator at `connect` ($TETFARM_COORDINATOR), and returns its name, such as "job-3"."""
    words = ["submit", path_word(surface_or_job), *_checked(options, connect)]
    line = _converse(words, None, on_message, time_limit).last("submitted")
    if line is None or not line.get("job"):
        raise ProtocolError("tetfarm ended well, but told no job")
    return str(line["job"])


def wait(job: str, output: Optional[PathText] = None, *, connect: Optional[str] = None,
         on_progress: Optional[OnProgress] = None, on_message: Optional[OnMessage] = None,
         time_limit: Optional[float] = None, **options: Option) -> Result:
    """Waits until a job has ended, and fetches its files into the folder `output`, if one is given.

    The errors are those of the job. When this call ends early, by Ctrl-C, `time_limit` or a callback, the job goes on.
    """
    where = [] if output is None else [f"--output={os.fspath(output)}"]
    words = ["wait", path_word(job), *where, *_checked(options, connect)]
    return _result_of(_converse(words, on_progress, on_message, time_limit))


def status(job: str, *, connect: Optional[str] = None, time_limit: Optional[float] = None,
           **options: Option) -> Dict[str, Any]:
    """How far a job is: the object `job` that `tetfarm status JOB --json` prints. `store="out"` asks the folder of a run."""
    line = ask(["status", path_word(job), "--json", *_checked(options, connect)], time_limit).last("job")
    if line is None:
        raise ProtocolError("tetfarm ended well, but told no job")
    return line


def jobs(*, connect: Optional[str] = None, time_limit: Optional[float] = None, **options: Option) -> List[Dict[str, Any]]:
    """All jobs: the objects that `tetfarm jobs --json` prints. `store="out"` asks the folder of a run."""
    ended = ask(["jobs", "--json", *_checked(options, connect)], time_limit)
    return [line for line in ended.output if line.get("type") == "job"]


def cancel(job: str, *, connect: Optional[str] = None, time_limit: Optional[float] = None, **options: Option) -> None:
    """Ends a job. One that is done or has failed stays as it is, and that is an error."""
    ask(["cancel", path_word(job), "--json", *_checked(options, connect)], time_limit)
