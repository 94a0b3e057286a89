# SPDX-License-Identifier: Apache-2.0
"""The commands of a shell's line, and what stands behind a program that only starts another one.

sleep 5 && SIDE=left ros2 run demo talker > log     sleep 5, and `ros2 run demo talker` with SIDE
bash -c 'ros2 run demo talker; exec bash'           ros2 run demo talker
xterm -hold -e ros2 run demo talker                 ros2 run demo talker
ros2 run demo talker --ros-args -r __ns:=/$ROBOT    the namespace is known as far as the variable is
"""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable, Sequence
from typing import Final

from rosward.deployment.execution.yaml_values import plain_text
from rosward.domain.text import make, origins_of, parts_of
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Hole, Value
from rosward.location import Place
from rosward.models.python.std.paths import basename
from rosward.records import NamedTuple

Look = Callable[[str], Value]
"""What a variable of the environment holds."""
Part = str | Hole

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
_STARTERS: Final = {
    **dict.fromkeys(("exec", "nohup", "setsid", "sudo", "time", "command", "env", "nice", "ionice", "stdbuf"), 0),
    **dict.fromkeys(("timeout", "taskset", "chrt"), 1),
}
"""Programs that start what stands behind them, with so many words of their own before it; their options aside."""
_WITH_VALUE: Final = ("-n", "-u", "-c", "-k", "-s", "-o", "-i", "-e", "-a", "-p")
"""Options of those whose value is the next word, if that is a number or a mode."""
_BUILTINS: Final = frozenset(
    (
        *("source", ".", "cd", "true", "false", ":", "wait", "set", "unset", "trap"),
        *("exit", "[", "[[", "test", "pwd", "ulimit", "alias", "read", "return", "break"),
    )
)
"""Commands of the shell itself: none of them is a process."""
_PREFIXES: Final = frozenset(
    {"if", "then", "else", "elif", "while", "until", "do", "!", "{", "done", "fi", "esac", "}"}
)
_HEADS: Final = frozenset({"for", "case", "select", "function"})
_ASSIGNED: Final = re.compile(r"([A-Za-z_]\w*)=")
_VARIABLE: Final = re.compile(r"\$(?:\{(\w+)(?::?-([^}]*))?\}|([A-Za-z_]\w*))")


class Command(NamedTuple):
    """One command in words, and the variables that it alone is given."""

    words: tuple[Value, ...]
    assigned: tuple[tuple[str, Value], ...] = ()


def of_line(line: Value, look: Look, place: Place, depth: int = 0) -> list[Command]:
    """The commands of a line, in order."""
    given: dict[str, Value] = {}
    inner_lines: list[Value] = []
    commands = _commands(line, look, place, inner_lines)
    found = [c for each in inner_lines if depth < _DEEP for c in of_line(each, look, place, depth + 1) if _matters(c)]
    for words in commands:
        if plain_text(words[0]) == "export":
            given.update(_assignment(word) for word in words[1:] if _is_assignment(word))
            continue
        inner = started_by(words, look, place, shell=True, depth=depth)
        found += [each._replace(assigned=(*given.items(), *each.assigned)) for each in inner]
    return found


def _matters(command: Command) -> bool:
    """Whether a command whose output goes into a line is one of ROS or of Python; most others only look something up."""
    return (plain_text(basename(command.words[0])) or "").startswith(("ros2", "python"))


def started_by(
    words: Sequence[Value], look: Look, place: Place, *, shell: bool = False, depth: int = 0
) -> list[Command]:
    """What these words start in the end. `shell`: a shell reads them."""
    left, assigned = tuple(words), dict[str, Value]()
    while left:
        name = plain_text(basename(left[0])) or ""
        if shell and _is_assignment(left[0]):
            assigned.update((_assignment(left[0]),))
            left = left[1:]
        elif shell and name in _PREFIXES:
            left = left[1:]
        elif name in _STARTERS and len(left) > 1:
            shell = shell or name == "env"
            left = _without_options(left[1:])[_STARTERS[name] :]
        elif name in _TERMINALS and (behind := _behind(left, _BEFORE_COMMAND)):
            if len(behind) == 1 and depth < _DEEP:
                return _with(of_line(behind[0], look, place, depth + 1), assigned)
            left = behind
        elif name in _SHELLS and (behind := _line_of(left)) and depth < _DEEP:
            return _with(of_line(behind[0], look, place, depth + 1), assigned)
        else:
            break
    name = plain_text(left[0]) or "" if left else ""
    if not left or (shell and (name in _BUILTINS or name in _HEADS or (name in _SHELLS and len(left) == 1))):
        return []
    return [Command(left, tuple(assigned.items()))]


def _with(commands: list[Command], assigned: dict[str, Value]) -> list[Command]:
    return [each._replace(assigned=(*assigned.items(), *each.assigned)) for each in commands]


def _behind(words: tuple[Value, ...], options: Sequence[str]) -> tuple[Value, ...]:
    """The words behind the first of these options."""
    return next((words[n + 1 :] for n, word in enumerate(words) if n and plain_text(word) in options), ())


def _line_of(words: tuple[Value, ...]) -> tuple[Value, ...]:
    """The words behind `-c`, which may stand among other letters (`bash -lc`)."""
    for number, word in enumerate(words[1:], 1):
        plain = plain_text(word) or ""
        if not plain.startswith("-"):
            return ()
        if not plain.startswith("--") and "c" in plain:
            return words[number + 1 :]
    return ()


def _without_options(words: tuple[Value, ...]) -> tuple[Value, ...]:
    left = words
    while left and (plain_text(left[0]) or "").startswith("-"):
        value = (plain_text(left[1]) or "") if len(left) > 1 else ""
        takes = plain_text(left[0]) in _WITH_VALUE and (value.lstrip("-").isalnum() and len(left) > 2)
        left = left[2:] if takes and not value.startswith("ros2") else left[1:]
    return left


def _is_assignment(word: Value) -> bool:
    first = parts_of(word)[0]
    return isinstance(first, str) and _ASSIGNED.match(first) is not None


def _assignment(word: Value) -> tuple[str, Value]:
    first, *rest = parts_of(word)
    assert isinstance(first, str)
    name, _, value = first.partition("=")
    return name, make((value, *rest), origins_of(word))


# From a line to words


def split(text: Value) -> tuple[Value, ...]:
    """The words of a text as a shell splits it, holes within words."""
    plain, holes = _with_marks(text)
    try:
        words = shlex.split(plain)
    except ValueError:
        words = plain.split()
    return tuple(make(_restored(word, holes), origins_of(text)) for word in words)


def _commands(line: Value, look: Look, place: Place, inner: list[Value]) -> list[tuple[Value, ...]]:
    """The commands in words; `inner` gets the lines of which only the output stands in this one."""
    plain, holes = _with_marks(line)
    plain, within = _expanded(plain.replace("\\\n", " ").replace("\n", " ; "), holes, look, place)
    inner += [make(_restored(each, holes), origins_of(line)) for each in within]
    reader = shlex.shlex(plain, posix=True, punctuation_chars=True)
    reader.whitespace_split = True
    reader.commenters = ""
    try:
        tokens = list(reader)
    except ValueError:
        tokens = plain.split()
    found: list[list[str]] = [[]]
    number = 0
    while number < len(tokens):
        token = tokens[number]
        number += 1
        if not token or token.strip("();<>|&"):
            found[-1].append(token)
        elif "<" in token or ">" in token:  # the number before it, and the file behind it
            if found[-1] and found[-1][-1] in ("0", "1", "2"):
                found[-1].pop()
            number += 1
        else:
            found.append([])
    return [tuple(make(_restored(word, holes), origins_of(line)) for word in each) for each in found if each]


def _with_marks(text: Value) -> tuple[str, list[tuple[Part, ...]]]:
    """The text with a mark for each hole, and what stands there."""
    holes: list[tuple[Part, ...]] = []
    plain = ""
    for part in parts_of(text):
        if isinstance(part, Hole):
            plain += f"\0{len(holes)}\0"
            holes.append((part,))
        else:
            plain += part.replace("\0", "")
    return plain, holes


def _restored(word: str, holes: Sequence[tuple[Part, ...]]) -> list[Part]:
    pieces = word.split("\0")
    return [each for n, piece in enumerate(pieces) for each in (holes[int(piece)] if n % 2 else (piece,))]


def _expanded(plain: str, holes: list[tuple[Part, ...]], look: Look, place: Place) -> tuple[str, list[str]]:
    """The line with marks for variables and for what commands in it print, and these commands."""
    done, number, quoted = "", 0, ""
    inner: list[str] = []
    while number < len(plain):
        char = plain[number]
        if char == "\\" and quoted != "'":
            done += plain[number : number + 2]
            number += 2
            continue
        if char in "'\"" and quoted in ("", char):
            quoted = "" if quoted else char
        elif quoted != "'" and char in "$`" and (found := _expansion(plain, number, look, place)) is not None:
            end, value = found
            if char == "`" or plain.startswith("$(", number):
                inner.append(plain[number + 1 + (char == "$") : end - 1])
            number = end
            done += f"\0{len(holes)}\0"
            holes.append(parts_of(value))
            continue
        done += char
        number += 1
    return done, inner


def _expansion(plain: str, number: int, look: Look, place: Place) -> tuple[int, Value] | None:
    """Where a variable or a command in a line ends, and what it gives."""
    if plain[number] == "`" or plain.startswith("$(", number):
        end = plain.find("`", number + 1) if plain[number] == "`" else _closing(plain, number + 1)
        hole = Hole((Reason(Cause.CALL, plain[number : end + 1], place),))
        return None if end < 0 else (end + 1, make((hole,), frozenset()))
    match = _VARIABLE.match(plain, number)
    return None if match is None else (match.end(), look(match[1] or match[3]))


def _closing(plain: str, number: int) -> int:
    depth = 0
    for place in range(number, len(plain)):
        depth += (plain[place] == "(") - (plain[place] == ")")
        if depth == 0:
            return place
    return -1
