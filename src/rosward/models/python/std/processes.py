# SPDX-License-Identifier: Apache-2.0
"""Programs that a program starts, its end, and what it is given: `subprocess`, `os.system`, `sys.exit`, `sys.argv`.

subprocess.Popen(['ros2', 'launch', 'demo', 'demo.launch.py'])   RW210: what it starts is not in the result
sys.exit(1)                                                      the path ends with SystemExit
"""

from __future__ import annotations

import re
from typing import Final

from rosward.domain.choice import options
from rosward.domain.compound import Tuple
from rosward.domain.text import parts_of, readable
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Const, Ref, Text, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import text_of
from rosward.models.python.shell.lines import of_line, started_by
from rosward.source.standard_library import STANDARD_LIBRARY

_STARTERS: Final = frozenset({"ros2", "rosrun", "roslaunch", "rviz2", "rqt", "gzserver", "gzclient", "gazebo"})


def _words(call: NativeCall, command: Value) -> list[str]:
    """The words of a command, `*` for what is not known of them."""
    if isinstance(command, Text) or text_of(command) is not None:
        return "".join(p if isinstance(p, str) else "*" for p in parts_of(command)).split()
    if not isinstance(command, (Ref, Tuple)):
        return []
    if isinstance(command, Ref) and call.machine.obj(command).kind != "list":
        return []
    items = call.machine.iterate(command)
    found: list[str] = []
    for item in items.known:
        option = options(item)[0]
        found.extend(readable(option).split() or [""])
    return found


def _is_known(call: NativeCall, command: Value) -> bool:
    """Whether all words of a command are known."""
    if command.__class__ is Tuple or (command.__class__ is Ref and call.machine.obj(command).kind == "list"):
        items = call.machine.series(command)
        return items.exact and all(text_of(item) is not None for item in items.head)
    return text_of(command) is not None


def launches(call: NativeCall, command: Value) -> None:
    """Report a command that starts ROS programs or Python ones."""
    if not _is_known(call, command):
        call.machine.note_creation(new=True, exact=False)
    for option in options(command):
        found = {_judged(names) for names in _commands(call, option)}
        code = next((c for c in ("RW210", "RW211") if c in found), "")
        if code:
            shown = " ".join(_words(call, option))
            message = f"{call.name.removesuffix('._launches')} starts `{shown[:200]}`"
            call.machine.report(code, message, (f"call ({call.machine.place})",))
            return


def _commands(call: NativeCall, command: Value) -> list[list[str]]:
    """The commands of a line, or of a list of words, each in words without their folders."""
    place = call.machine.place

    def held(name: str, _: str | None) -> Value:
        return call.machine.unknown(Cause.ENVIRONMENT, name, "str")

    if not isinstance(command, (Ref, Tuple)):
        found = of_line(command, held, place)
    elif isinstance(command, Tuple) or call.machine.obj(command).kind == "list":
        found = started_by([options(word)[0] for word in call.machine.iterate(command).known], held, place)
    else:
        found = []
    shown = ((readable(word) for word in each.words) for each in found)
    return [[name.rpartition("/")[2] for word in words for name in word.split() or [""]] for words in shown]


def _judged(names: list[str]) -> str:
    """What is told of a command: '' where it starts nothing of ROS and no Python."""
    if not names or names[0] in _ONLY_LOOK:
        return ""
    python = any(_runs_python(names[n:]) for n, name in enumerate(names) if n == 0 or _PYTHON.fullmatch(name))
    if python or any(n in _STARTERS or n.endswith((".launch.py", ".launch.xml")) for n in names):
        return "RW211" if _is_tool(names) else "RW210"
    return ""


_PYTHON: Final = re.compile(r"python[\d.]*")
_TOOLS: Final = frozenset({"pip", "pytest", "build", "mypy", "ruff", "black", "flake8", "coverage"})
"""Modules that are run by `python -m` and are no nodes."""
_ONLY_LOOK: Final = frozenset({"pgrep", "pkill", "killall", "kill", "grep", "echo", "printf", "cat", "which"})
"""Programs that look for others, or end them: what stands behind starts nothing."""

_STARTING: Final = frozenset({"run", "launch", "component", "bag"})
"""Subcommands of ros2 by which nodes are started."""


def _is_tool(names: list[str]) -> bool:
    """Whether a command is one of ROS's own tools that asks or tells something and starts no node."""
    return len(names) > 1 and names[0] == "ros2" and names[1].isalpha() and names[1] not in _STARTING


def _runs_python(names: list[str]) -> bool:
    """`python3 node.py`, `python3 -m arm.node`, also where the interpreter is `sys.executable`, which is not known."""
    if not names or not names[0].startswith(("python", "*")):
        return False
    if "-m" in names[1:-1]:
        module = names[names.index("-m") + 1].partition(".")[0]
        return module not in STANDARD_LIBRARY and module not in _TOOLS
    return any(n.endswith(".py") for n in names[1:])


def _command(call: NativeCall) -> Value:
    """subprocess._launches(command): the finding alone."""
    if call.args:
        launches(call, call.args[0])
    return NONE


def _system(call: NativeCall) -> Value:
    command = call.arg(0, "command") or call.arg(0, "cmd")
    if command is not None:
        launches(call, command)
    return call.machine.unknown(Cause.CALL, call.name, "int" if call.name.endswith("system") else "")


def _of_words(call: NativeCall, words: tuple[Value, ...]) -> None:
    """Report a command that is given in words, or in lists of them."""
    flat: list[Value] = []
    for arg in words:
        flat.extend(call.machine.iterate(arg).known if isinstance(arg, (Ref, Tuple)) else (arg,))
    launches(call, Tuple(tuple(flat)))


def _spawned(behind: int) -> NativeFunction:
    """What starts a program beside this one; its words begin behind so many arguments."""

    def spawn(call: NativeCall) -> Value:
        _of_words(call, call.args[behind:])
        return call.machine.unknown(Cause.CALL, call.name)

    return spawn


def _exec(call: NativeCall) -> Value:
    """os.exec*: the program is replaced by another one."""
    _of_words(call, call.args[1:])
    return call.machine.die("SystemExit", "replaced by another program")


def _exit(call: NativeCall) -> Value:
    status = call.args[0] if call.args else NONE
    return call.machine.die("SystemExit", str(status.value) if isinstance(status, Const) else "", call.args)


def _argv(call: NativeCall) -> Value:
    """The program, then what somebody types."""
    word = call.machine.unknown(Cause.ARGUMENT, "sys.argv", "str")
    return call.machine.new_list((word,), word)


def _made_at_run_time(call: NativeCall) -> Value:
    what = next((t for t in map(text_of, call.args) if t), "")
    call.machine.report(
        "RW203",
        f"{call.name}({what!r}) runs code that is not analysed"
        if what
        else f"{call.name} runs code that is not analysed",
    )
    return call.machine.unknown(Cause.MODULE, call.name)


def _input(cause: Cause, hint: str, subject: str = "") -> NativeFunction:
    def read(call: NativeCall) -> Value:
        return call.machine.unknown(cause, subject or call.name, hint)

    return read


_FILES_AS_LIST: Final = ("os.scandir", "os.walk", "fnmatch.filter")


def _listing(call: NativeCall) -> Value:
    """A list of unknown length: of texts, or of what the system tells of files."""
    where = (text_of(call.args[0]) if call.args else None) or call.name
    hint = "" if call.name in {"os.walk", "os.scandir"} else "str"
    return call.machine.new_list((), call.machine.unknown(Cause.FILE, where, hint))


_SUFFIXES: Final = ("l", "le", "lp", "lpe", "v", "ve", "vp", "vpe")
"""How the functions of `os` that start a program are told apart."""

NATIVES: Final[dict[str, NativeFunction]] = {
    "sys.exit": _exit,
    "os._exit": _exit,
    "os.abort": _exit,
    "sys._argv": _argv,
    "os.system": _system,
    "os.popen": _system,
    **dict.fromkeys(("pexpect.spawn", "pexpect.run", "asyncio.create_subprocess_shell"), _system),
    **dict.fromkeys(("pty.spawn", "asyncio.create_subprocess_exec"), _spawned(0)),
    **{f"os.posix_spawn{suffix}": _spawned(1) for suffix in ("", "p")},
    **{f"os.spawn{suffix}": _spawned(2) for suffix in _SUFFIXES},
    "subprocess._launches": _command,
    **{f"os.exec{suffix}": _exec for suffix in _SUFFIXES},
    "runpy.run_path": _made_at_run_time,
    "runpy.run_module": _made_at_run_time,
    **dict.fromkeys(_FILES_AS_LIST, _listing),
    "os.getcwd": _input(Cause.LIVE, "str", "current directory"),
    "select.select": _input(Cause.INPUT, "tuple"),
    "sys._read": _input(Cause.INPUT, "str", "standard input"),
    "getpass.getpass": _input(Cause.INPUT, "str"),
}
