"""What can go wrong, as exceptions: one for each exit code of the program, and a few for what it cannot tell itself."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

if TYPE_CHECKING:
    from .jobs import Result


class TetfarmError(Exception):
    """The program ended with an error.

    `message` says what is wrong, `help` what to do about it ("": nothing useful can be said), and `exit_code` is that of
    the program, None where it did not get so far.
    """

    def __init__(self, message: str, *, help: str = "", exit_code: Optional[int] = None) -> None:
        super().__init__(message, help, exit_code)
        self.message = message
        self.help = help
        self.exit_code = exit_code

    def __str__(self) -> str:
        return f"{self.message}\nhelp: {self.help}" if self.help else self.message

    def __reduce__(self):  # that it can be sent from process to process
        return (_again, (type(self), self.args, self.__dict__))


def _again(kind, args, state):
    error = kind.__new__(kind, *args)
    error.args = args
    error.__dict__.update(state)
    return error


class UsageError(TetfarmError):
    """Exit code 2: an option or the job file is wrong."""


class GeometryError(TetfarmError):
    """Exit code 3: the surface cannot be read or meshed; the message says where."""


class GateError(TetfarmError):
    """Exit code 4: the mesh is there, as `result`, but its angles are below what `[quality]` of the job asks for."""

    result: "Result"


class NotFoundError(TetfarmError):
    """Exit code 5: no such file or job, or no coordinator answers."""


class ResourcesError(TetfarmError):
    """Exit code 6: out of disk or memory. Make room, and the same call goes on."""


class StoppedError(TetfarmError):
    """Exit code 75: somebody stopped the program at a checkpoint. The same call goes on."""


class TimeLimitError(TetfarmError):
    """The `time_limit` of the call was over, and the program was stopped. The same call goes on."""


class ProgramDiedError(TetfarmError):
    """The program ended without saying why: it was killed, or crashed. `exit_code` is negative where a signal did it."""


class ProgramNotFoundError(TetfarmError):
    """There is no program `tetfarm` to run."""


class ProtocolError(TetfarmError):
    """What the program said is not what this module understands: the two may be of different versions."""


class MeshFileError(TetfarmError, ValueError):
    """A file is not a mesh that can be read."""


class MissingLibraryError(TetfarmError, ImportError):
    """A library of Python is missing; `help` says how to install it."""


_OF_CODE = {2: UsageError, 3: GeometryError, 4: GateError, 5: NotFoundError, 6: ResourcesError, 75: StoppedError}


def error_of(exit_code: int, message: str, help: str = "") -> TetfarmError:
    """The exception for an exit code of the program."""
    return _OF_CODE.get(exit_code, TetfarmError)(message, help=help, exit_code=exit_code)
