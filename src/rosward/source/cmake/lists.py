# SPDX-License-Identifier: Apache-2.0
"""What do the commands of CMake do that only compute: `list`, `string`, `math`, `get_filename_component`, `cmake_parse_arguments`?

Each takes its arguments and the variables, and says whether it understood. What it does not understand is not known afterwards: the
interpreter puts a hole into what it would have written.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Final

from rosward.source.cmake.variables import Variables, split

_NUMBER: Final = re.compile(r"-?\d{1,9}")
_SIMPLE: Final = re.compile(r"[^*+{\\(|]*(?:\.\*)?[^*+{\\(|]*")
"""A regular expression with at most one repetition: it can be tried on a text in bounded time."""

SET_OPERATION: Final = re.compile(r"\[\[|\[[^\]]*(?:--|&&|~~|\|\|)")
"""What Python may once read in another way than CMake does."""


def change_list(arguments: list[str], variables: Variables) -> bool:
    """`list(OPERATION name …)`."""
    operation, name, *values = arguments
    now = variables.elements(name)
    match operation:
        case "APPEND":
            variables.set(name, now + values)
        case "PREPEND":
            variables.set(name, values + now)
        case "REMOVE_ITEM":
            unwanted = set(values)
            variables.set(name, [item for item in now if item not in unwanted])
        case "REMOVE_DUPLICATES":
            variables.set(name, list(dict.fromkeys(now)))
        case "SORT":
            variables.set(name, sorted(now))
        case _:
            return _ask_list(operation, name, now, values, variables)
    return True


def _ask_list(operation: str, name: str, now: list[str], values: list[str], variables: Variables) -> bool:
    match operation, values:
        case "LENGTH", [into]:
            variables.set(into, [str(len(now))])
        case "GET", [*places, into] if all(map(_NUMBER.fullmatch, places)):
            variables.set(into, [now[int(p)] for p in places if -len(now) <= int(p) < len(now)])
        case "FIND", [value, into]:
            variables.set(into, [str(now.index(value)) if value in now else "-1"])
        case "JOIN", [glue, into]:
            variables.values[into] = glue.join(now)[:100_000]
        case "REVERSE", []:
            variables.set(name, now[::-1])
        case "INSERT", [place, *new] if _NUMBER.fullmatch(place):
            variables.set(name, now[: int(place)] + new + now[int(place) :])
        case "SUBLIST", [start, length, into] if _NUMBER.fullmatch(start) and _NUMBER.fullmatch(length):
            end = len(now) if int(length) < 0 else int(start) + int(length)
            variables.set(into, now[int(start) : end])
        case "REMOVE_AT", places if all(map(_NUMBER.fullmatch, places)):
            unwanted = {int(p) % len(now) for p in places} if now else set[int]()
            variables.set(name, [item for place, item in enumerate(now) if place not in unwanted])
        case (("POP_BACK" | "POP_FRONT"), into):
            at = -1 if operation == "POP_BACK" else 0
            for each in into or [""]:
                item = now.pop(at) if now else ""
                if each:
                    variables.set(each, [item])
            variables.set(name, now)
        case "FILTER", [mode, "REGEX", pattern] if _tried(_sought(pattern)):
            wanted = mode == "INCLUDE"
            found = re.compile(_sought(pattern)).search
            variables.set(name, [i for i in now if (found(i[:1_000]) is not None) is wanted])
        case "TRANSFORM", [action, text] if action in {"PREPEND", "APPEND"}:
            variables.set(name, [text + i if action == "PREPEND" else i + text for i in now])
        case _:
            return False
    return True


def _sought(pattern: str) -> str:
    """The same where a text is searched: `.*` at its beginning says nothing there."""
    return pattern.removeprefix(".*")


def _tried(pattern: str) -> bool:
    if len(pattern) > 200 or _SIMPLE.fullmatch(pattern) is None or SET_OPERATION.search(pattern):
        return False
    try:
        re.compile(pattern)
    except re.error:
        return False
    return True


def change_string(arguments: list[str], variables: Variables) -> bool:
    """`string(OPERATION …)`."""
    put = variables.values.__setitem__
    match arguments:
        case ["TOUPPER", text, into]:
            put(into, text.upper())
        case ["TOLOWER", text, into]:
            put(into, text.lower())
        case ["STRIP", text, into]:
            put(into, text.strip())
        case ["LENGTH", text, into]:
            put(into, str(len(text)))
        case ["CONCAT", into, *texts]:
            variables.set(into, ["".join(texts)])
        case ["APPEND", into, *texts]:
            variables.set(into, [variables.get(into) + "".join(texts)])
        case ["JOIN", glue, into, *texts]:
            variables.set(into, [glue.join(texts)])
        case ["REPLACE", old, new, into, *texts] if old:
            text = "".join(texts)
            variables.set(into, [text.replace(old, new) if text.count(old) * len(new) < 100_000 else text])
        case ["SUBSTRING", text, start, length, into] if _NUMBER.fullmatch(start) and _NUMBER.fullmatch(length):
            put(into, text[int(start) : None if int(length) < 0 else int(start) + int(length)])
        case ["FIND", text, part, into, *_]:
            put(into, str(text.find(part)))
        case ["REGEX", "REPLACE", pattern, new, into, *texts] if _tried(pattern) and "\\" not in new:
            text = "".join(texts)[:10_000]
            put(into, re.sub(pattern, new, text) if len(text) * len(new) < 1_000_000 else text)
        case _:
            return False
    return True


def compute(arguments: list[str], variables: Variables) -> bool:
    """`math(EXPR name "a + b")`, for one operator."""
    if len(arguments) < 3 or arguments[0] != "EXPR":
        return False
    found = re.fullmatch(r"\s*(-?\d{1,9})\s*(?:([-+*/%])\s*(-?\d{1,9})\s*)?", arguments[2])
    if found is None:
        return False
    left, right = int(found[1]), int(found[3] or 0)
    if found[2] in {"/", "%"} and not right:
        return False
    results = {None: left, "+": left + right, "-": left - right, "*": left * right}
    value = results[found[2]] if found[2] in results else left // right if found[2] == "/" else left % right
    variables.set(arguments[1], [str(value)])
    return True


def path_component(arguments: list[str], variables: Variables) -> bool:
    """`get_filename_component(name path WHICH)`."""
    if len(arguments) < 3:
        return False
    variables.set(arguments[0], [component(arguments[1], arguments[2])])
    return True


_PARTS: Final[Mapping[str, str]] = {
    "FILENAME": "NAME",
    "STEM": "NAME_WE",
    "EXTENSION": "EXT",
    "PARENT_PATH": "DIRECTORY",
}
"""Parts of a path for `cmake_path`, as `get_filename_component` names them."""


def path_part(arguments: list[str], variables: Variables) -> bool:
    """`cmake_path(GET variable PART name)`; nothing else of it is known."""
    if len(arguments) != 4 or arguments[0] != "GET" or arguments[2] not in _PARTS:
        return False
    variables.set(arguments[3], [component(variables.values.get(arguments[1], ""), _PARTS[arguments[2]])])
    return True


def component(path: str, which: str) -> str:
    """A part of a path."""
    name = path.rpartition("/")[2]
    match which:
        case "NAME":
            return name
        case "NAME_WE":
            return name.partition(".")[0]
        case "NAME_WLE":
            return name.rpartition(".")[0] or name
        case "EXT":
            return name[name.index(".") :] if "." in name else ""
        case "DIRECTORY" | "PATH":
            return path.rpartition("/")[0]
        case _:
            return path


def parse_arguments(arguments: list[str], variables: Variables) -> bool:
    """`cmake_parse_arguments(PREFIX options one_value multi_value …)`, also with PARSE_ARGV."""
    if arguments[:1] == ["PARSE_ARGV"] and len(arguments) >= 6:
        first = int(arguments[1]) if _NUMBER.fullmatch(arguments[1]) else 0
        arguments = [*arguments[2:6], *variables.elements("ARGV")[first:]]
    if len(arguments) < 4:
        return False
    prefix, (options, single, several) = arguments[0], (set(split(a)) for a in arguments[1:4])
    results: dict[str, list[str]] = {}
    for option in options:
        variables.values[f"{prefix}_{option}"] = "FALSE"
    for keyword in single | several:
        variables.values.pop(f"{prefix}_{keyword}", None)
    key = "UNPARSED_ARGUMENTS"
    variables.values.pop(f"{prefix}_{key}", None)
    for argument in arguments[4:]:
        if argument in options:
            variables.values[f"{prefix}_{argument}"] = "TRUE"
            key = "UNPARSED_ARGUMENTS"
        elif argument in single or argument in several:
            key = argument
        else:
            results.setdefault(key, []).append(argument)
            if key in single:
                key = "UNPARSED_ARGUMENTS"
    for key, values in results.items():
        variables.set(f"{prefix}_{key}", values)
    return True


def loop_items(arguments: list[str], variables: Variables) -> Iterator[str]:
    """What a `foreach(name …)` goes through."""
    rest = arguments[1:]
    if rest[:1] == ["RANGE"]:
        numbers = [int(a) for a in rest[1:] if re.fullmatch(r"-?\d{1,4}", a)]
        if numbers:
            start = numbers[0] if len(numbers) > 1 else 0
            step = numbers[2] if len(numbers) > 2 and numbers[2] > 0 else 1
            yield from map(str, range(start, numbers[min(1, len(numbers) - 1)] + 1, step))
    elif rest[:1] == ["IN"]:
        mode = "ITEMS"
        for argument in rest[1:]:
            if argument in {"LISTS", "ITEMS", "ZIP_LISTS"}:
                mode = argument
            elif mode == "LISTS":
                yield from variables.elements(argument)
            else:
                yield argument
    else:
        yield from rest


Computation = Callable[[list[str], Variables], bool]

COMPUTATIONS: Final[Mapping[str, Computation]] = {
    "get_filename_component": path_component,
    "string": change_string,
    "math": compute,
    "cmake_path": path_part,
    "cmake_parse_arguments": parse_arguments,
}
"""By the name of the command."""
