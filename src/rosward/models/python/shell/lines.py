# SPDX-License-Identifier: Apache-2.0
"""The commands of a shell's line, and what stands behind a program that only starts another one.

sleep 5 && SIDE=left ros2 run demo talker > log     sleep 5, and `ros2 run demo talker` with SIDE
bash -c 'ros2 run demo talker; exec bash'           ros2 run demo talker
xterm -hold -e ros2 run demo talker                 ros2 run demo talker
ros2 run demo talker --ros-args -r __ns:=/$ROBOT    the namespace is known as far as the variable is
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import Final

from rosward.domain.text import concat, make, origins_of, parts_of, readable
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Unknown, Value
from rosward.location import Place
from rosward.models.python.plain import text_of
from rosward.models.python.shell.words import Variable, Word, read_line, split
from rosward.records import NamedTuple

Look = Callable[[str, str | None], Value]
"""What a variable of the environment holds, or the default that a line gives it."""

_DEEP: Final = 8
_SHELLS: Final = ("bash", "sh", "dash", "zsh")
_TERMINALS: Final = (
    "xterm",
    "gnome-terminal",
    "konsole",
    "terminator",
    "xfce4-terminal",
    "lxterminal",
    "x-terminal-emulator",
)
_BEFORE_COMMAND: Final = ("-e", "-x", "--", "--command", "--execute")
_STARTERS: Final[dict[str, tuple[int, str]]] = {
    **dict.fromkeys(("nohup", "setsid", "command"), (0, "")),
    "chrt": (1, ""),
    "env": (0, "uCS"),
    "exec": (0, "a"),
    "flock": (1, "wE"),
    "ionice": (0, "cn"),
    "nice": (0, "n"),
    "stdbuf": (0, "ioe"),
    "sudo": (0, "ugpChrtTDR"),
    "taskset": (1, ""),
    "time": (0, "of"),
    "timeout": (1, "ks"),
}
"""Programs that start what stands behind them: how many words of their own are before it, and the options whose value is the next word."""
_BUILTINS: Final = frozenset(
    (
        *("source", ".", "cd", "true", "false", ":", "wait", "set", "unset", "trap"),
        *("exit", "[", "[[", "test", "pwd", "ulimit", "alias", "read", "return", "break", "continue", "shift"),
    )
)
"""Commands of the shell itself: none of them is a process."""
_PREFIXES: Final = frozenset(
    {"if", "then", "else", "elif", "while", "until", "do", "!", "{", "done", "fi", "esac", "}", "coproc"}
)
_HEADS: Final = frozenset({"for", "case", "select", "function"})
_OWN_LINES: Final = ("eval", "trap")
"""Commands of the shell that are given a line."""
_LOOSE: Final = frozenset({"!", "{", "}", "coproc"})
"""Of the prefixes, those behind which a command runs in any case."""
_SETTERS: Final = frozenset({"export", "declare", "typeset", "readonly", "local"})
_ASSIGNED: Final = re.compile(r"([A-Za-z_]\w*)=")
_NAME: Final = re.compile(r"[A-Za-z_]\w*")
_BLANK: Final = Const(" ")
_LONGEST: Final = 4_096
"""What a line gives a variable is known up to so many characters: `X=$X$X` makes more of them at each time."""


class Command(NamedTuple):
    """One command in words, and the variables that it alone is given."""

    words: tuple[Value, ...]
    assigned: tuple[tuple[str, Value], ...] = ()


def of_line(line: Value, look: Look, place: Place, depth: int = 0) -> list[Command]:
    """The commands of a line, in order."""
    commands, inner_lines = read_line(line, place)
    found = [c for each in inner_lines if depth < _DEEP for c in of_line(each, look, place, depth + 1) if _matters(c)]
    shell = _Shell(look, place, commands)
    for number, (operator, pieces) in enumerate(commands):
        shell.enter(operator)
        words = shell.words(pieces)
        behind = commands[number + 1][0] if number + 1 < len(commands) else ""
        if behind.startswith("()") and len(words) == 1:
            shell.functions.add(text_of(words[0]))
            shell.control(number)
        elif words and not shell.does(words, number):
            inner = started_by(words, shell.given, place, shell=True, depth=depth)
            found += _with(inner, shell.exported)
    return found


class _Shell:
    """What a line has set so far: variables, those of them that programs are given, and functions."""

    def __init__(self, look: Look, place: Place, commands: list[tuple[str, list[Word]]]) -> None:
        self.look, self.place, self.commands = look, place, commands
        operators = [operator.strip("()") for operator, _ in commands]
        self.own: dict[str, Value] = {}
        self.exported: dict[str, Value] = {}
        self.functions: set[str | None] = set()
        self.outside: list[tuple[dict[str, Value], dict[str, Value]]] = []
        last = len(operators)
        self.sure_until = next((n for n, o in enumerate(operators) if o not in ("", ";", "&&")), last + 1)
        self.alike_until = operators.index("&&") if "&&" in operators else last
        self.alike_from = max((n for n, o in enumerate(operators) if o != "&&"), default=0)

    def enter(self, operator: str) -> None:
        """What stands between two commands; what is set within brackets ends with them."""
        for char in operator:
            if char == "(":
                self.outside.append((self.own.copy(), self.exported.copy()))
            elif char == ")" and self.outside:
                self.own, self.exported = self.outside.pop()

    def words(self, pieces: Sequence[Word]) -> list[Value]:
        """The words of a command, variables replaced by what they hold now."""
        found: list[Value] = []
        for word in pieces:
            held = [self.held(p.name, p.default) if isinstance(p, Variable) else make((p,)) for p in word]
            first = word[0]
            apart = len(word) == 1 and isinstance(first, Variable) and first.apart and text_of(held[0]) is not None
            found += split(held[0]) if apart else (concat(held),)
        return found

    def held(self, name: str, default: str | None) -> Value:
        """What a variable holds in this line."""
        return self.own[name] if name in self.own else self.look(name, default)

    def given(self, name: str, default: str | None) -> Value:
        """What a variable holds in what this line starts."""
        return self.exported[name] if name in self.exported else self.look(name, default)

    def does(self, words: list[Value], number: int) -> bool:
        """Whether a command is one of the shell alone: it sets variables, or calls or begins a function."""
        while words and (name := text_of(words[0]) or "") in _PREFIXES:
            if name not in _LOOSE:
                self.control(number)
            words = words[1:]
        if not words:
            return True
        name = text_of(words[0]) or ""
        if name == "function":
            self.functions.add(text_of(words[1]) if len(words) > 1 else None)
            self.control(number)
            return len(words) < 3
        if name in _HEADS:
            self.control(number)
        if name in _HEADS or name in ("read", "unset"):
            for word in words[1:]:
                self._set(text_of(word) or "", self._unknown(text_of(word) or ""), exports=False)
            return True
        setter = name in _SETTERS
        if not setter and not all(map(_is_assignment, words)):
            return name in self.functions
        exports = name == "export" or (setter and any(text_of(word) == "-x" for word in words))
        sure = number + 1 < self.sure_until and (number < self.alike_until or number >= self.alike_from)
        for word in words[setter:]:
            if _is_assignment(word):
                variable, value = _assignment(word)
                before = self.own.get(variable)
                self._set(variable, value if sure or value == before else self._unknown(variable), exports)
            elif exports and (variable := text_of(word) or "") in self.own:
                self._set(variable, self.own[variable], exports)
        return True

    def control(self, number: int) -> None:
        """Commands from here on may run or not, or several times: what they set may be so from the beginning."""
        if number < self.sure_until:
            self.sure_until = number
            for first in (word[0] for _, words in self.commands[number:] for word in words):
                match = _ASSIGNED.match(first) if isinstance(first, str) else None
                if match is not None and match[1] in self.own:
                    self._set(match[1], self._unknown(match[1]), exports=False)

    def _set(self, name: str, value: Value, exports: bool) -> None:
        if _NAME.fullmatch(name):
            if sum(len(p) for p in parts_of(value) if isinstance(p, str)) > _LONGEST:
                value = Unknown((Reason(Cause.LIMIT, name, self.place),), "str")
            self.own[name] = value
            if exports or name in self.exported:
                self.exported[name] = value

    def _unknown(self, name: str) -> Value:
        return Unknown((Reason(Cause.ENVIRONMENT, name, self.place),), "str")


def _matters(command: Command) -> bool:
    """Whether a command whose output goes into a line is one of ROS or of Python; most others only look something up."""
    return _program(command.words[0]).startswith(("ros2", "python"))


def started_by(
    words: Sequence[Value], look: Look, place: Place, *, shell: bool = False, depth: int = 0
) -> list[Command]:
    """What these words start in the end. `shell`: a shell reads them."""
    left, assigned = tuple(words), dict[str, Value]()

    def given(name: str, default: str | None) -> Value:
        return assigned[name] if name in assigned else look(name, default)

    def lines(line: Value) -> list[Command]:
        return _with(of_line(line, given, place, depth + 1), assigned)

    while left:
        name = _program(left[0])
        if shell and _is_assignment(left[0]):
            assigned.update((_assignment(left[0]),))
            left = left[1:]
        elif shell and name in _PREFIXES:
            left = left[1:]
        elif shell and name == "function":
            left = left[2:]
        elif name in _STARTERS and len(left) > 1:
            shell = shell or name == "env"
            own, valued = _STARTERS[name]
            left = _without_options(left[1:], valued)[own:]
        elif name in _TERMINALS and (behind := _behind(left, _BEFORE_COMMAND)):
            if len(behind) == 1 and depth < _DEEP:
                return lines(behind[0])
            left = behind
        elif name in _SHELLS and (behind := _line_of(left)) and depth < _DEEP:
            return lines(behind[0])
        elif shell and name in _OWN_LINES and len(left) > 1 and text_of(left[1]) is not None and depth < _DEEP:
            line = concat(p for word in left[1:] for p in (word, _BLANK)) if name == "eval" else left[1]
            return lines(line)
        else:
            break
    name = text_of(left[0]) or "" if left else ""
    idle = name in _SHELLS and all((text_of(word) or "").startswith("-") for word in left[1:])
    if not left or (shell and (name in _BUILTINS or name in _HEADS or idle)):
        return []
    return [Command(left, tuple(assigned.items()))]


def _with(commands: list[Command], assigned: dict[str, Value]) -> list[Command]:
    return [each._replace(assigned=(*assigned.items(), *each.assigned)) for each in commands]


def _behind(words: tuple[Value, ...], options: Sequence[str]) -> tuple[Value, ...]:
    """The words behind the first of these options."""
    return next((words[n + 1 :] for n, word in enumerate(words) if n and text_of(word) in options), ())


def _line_of(words: tuple[Value, ...]) -> tuple[Value, ...]:
    """The words behind `-c`, which may stand among other letters (`bash -lc`)."""
    for number, word in enumerate(words[1:], 1):
        plain = text_of(word) or ""
        if not plain.startswith("-"):
            return ()
        if not plain.startswith("--") and "c" in plain:
            return words[number + 1 :]
    return ()


def _without_options(words: tuple[Value, ...], valued: str) -> tuple[Value, ...]:
    left = words
    while left and (option := text_of(left[0]) or "").startswith("-"):
        left = left[2 if len(option) == 2 and option[1] in valued else 1 :]
        if option == "--":
            break
    return left


def _program(word: Value) -> str:
    """The name of a program without its folder."""
    return readable(word).rpartition("/")[2]


def _is_assignment(word: Value) -> bool:
    first = parts_of(word)[0]
    return isinstance(first, str) and _ASSIGNED.match(first) is not None


def _assignment(word: Value) -> tuple[str, Value]:
    first, *rest = parts_of(word)
    assert isinstance(first, str)
    name, _, value = first.partition("=")
    return name, make((value, *rest), origins_of(word))
