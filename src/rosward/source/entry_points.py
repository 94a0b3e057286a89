# SPDX-License-Identifier: Apache-2.0
"""Which functions does a Python package declare as its commands?

    "talker = demo.talker:main"  ->  EntryPoint("talker", "demo.talker", "main")

One record and one parser for every place in which they are declared, `setup.py`, `setup.cfg` and `pyproject.toml`;
the latter two are read here.
"""

from __future__ import annotations

import configparser
import re
from typing import TYPE_CHECKING, Final

from rosward.findings import Finding
from rosward.location import Place
from rosward.records import NamedTuple
from rosward.source import limits
from rosward.source.text import read_bytes
from rosward.source.toml import read_toml

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping


_DOTTED = r"[^\W\d]\w*(?:\s*\.\s*[^\W\d]\w*)*"
_MODULE = r"\w+(?:\s*\.\s*\w+)*"  # imported by its name: no identifiers
_ENTRY_POINT: Final = re.compile(rf"\s*([^=\s\[][^=\n]*?)\s*=\s*({_MODULE})\s*:\s*({_DOTTED})\s*(?:\[[^\]\n]*\]\s*)?")


class EntryPoint(NamedTuple):
    """A command `name` that calls `function` (dotted where it is a method) of `module`, declared at `place`."""

    name: str
    module: str
    function: str
    place: Place


class PythonSide(NamedTuple):
    """What the build description of a package declares of its Python side.

    `scripts` are files, relative to the package, that are installed as they are. `package_dir` maps a Python package
    (`""` for all) to its folder, as setuptools means it. `name` is empty where it is not said, or not readable.
    `data_files` are where a file is installed, as `share/demo/launch/a.launch.py`, and the file, relative to the package;
    `all_data` tells whether these are all. `generated` are modules that the build makes: name, description, validation module.
    """

    name: str = ""
    entry_points: tuple[EntryPoint, ...] = ()
    scripts: tuple[tuple[str, Place], ...] = ()
    package_dir: tuple[tuple[str, str], ...] = ()
    findings: tuple[Finding, ...] = ()
    data_files: tuple[tuple[str, str, Place], ...] = ()
    all_data: bool = True
    generated: tuple[tuple[str, str, str, Place], ...] = ()

    def __or__(self, other: object) -> PythonSide:
        """Both together; what `self` says of name and folders comes first."""
        if not isinstance(other, PythonSide):
            return NotImplemented
        known = {entry[:3] for entry in self.entry_points}
        return PythonSide(
            self.name or other.name,
            self.entry_points + tuple(entry for entry in other.entry_points if entry[:3] not in known),
            self.scripts + other.scripts,
            self.package_dir + other.package_dir,
            self.findings + other.findings,
            self.data_files + other.data_files,
            self.all_data and other.all_data,
            self.generated + other.generated,
        )


def parse_entry_point(text: str) -> tuple[str, str, str] | None:
    """Name, module and function of an entry point, or `None` where it is not one that a command can be made of."""
    if len(text) > 1000:
        return None
    match = _ENTRY_POINT.fullmatch(text)
    return (match[1], "".join(match[2].split()), "".join(match[3].split())) if match else None


def entry_points(texts: Iterable[tuple[str, Place]]) -> tuple[tuple[EntryPoint, ...], tuple[Finding, ...]]:
    """The entry points that `texts` spell, with a finding for each text that is none."""
    good: list[EntryPoint] = []
    bad: list[Finding] = []
    for text, place in texts:
        parsed = parse_entry_point(text)
        if parsed is None:
            message = f"This is not an entry point of the form 'name = module:function': {text[:100]!r}."
            bad.append(Finding("RW008", message, place))
        else:
            good.append(EntryPoint(*parsed, place))
    return tuple(good), tuple(bad)


def text_lines(text: str) -> list[str]:
    """The entry points in the text form of `entry_points`: one a line, with comments and blank lines left out."""
    return [line for line in map(str.strip, text.splitlines()) if line and not line.startswith(("#", ";"))]


def read_setup_cfg(path: str, file: str) -> PythonSide:
    """What the `setup.cfg` at `path`, called `file`, declares."""
    text = _read_text(path, file)
    if isinstance(text, Finding):
        return PythonSide(findings=(text,))
    config = configparser.RawConfigParser(strict=False)
    try:
        config.read_string(text)
    except configparser.Error as error:
        line = getattr(error, "lineno", None) or next((number for number, _ in getattr(error, "errors", ())), 0)
        return PythonSide(
            findings=(Finding("RW008", "The setup.cfg is not a valid configuration file.", Place(file, line)),)
        )
    lines = _Lines(text, file)

    def get(section: str, option: str) -> str:
        return config.get(section, option, fallback=None) or ""

    commands = [
        line for kind in ("console_scripts", "gui_scripts") for line in text_lines(get("options.entry_points", kind))
    ]
    points, findings = entry_points((command, lines.of(command)) for command in commands)
    folders = [line.partition("=") for line in re.split(r"[\n,]", get("options", "package_dir")) if "=" in line]
    return PythonSide(
        get("metadata", "name"),
        points,
        tuple((script, lines.of(script)) for script in text_lines(get("options", "scripts"))),
        tuple((package.strip(), folder.strip()) for package, _, folder in folders),
        findings,
    )


def read_pyproject(path: str, file: str) -> PythonSide:
    """What the `pyproject.toml` at `path`, called `file`, declares."""
    text = _read_text(path, file)
    if isinstance(text, Finding):
        return PythonSide(findings=(text,))
    try:
        document = read_toml(text)
    except ValueError as error:
        line = re.search(r"at line (\d+)", str(error))
        place = Place(file, int(line[1]) if line else 0)
        return PythonSide(findings=(Finding("RW008", "The pyproject.toml is not valid TOML.", place),))
    lines = _Lines(text, file)
    project = _table(document, "project")
    poetry = _table(document, "tool", "poetry")
    commands: list[tuple[str, Place]] = []
    for table in (_table(project, "scripts"), _table(project, "gui-scripts"), _table(poetry, "scripts")):
        for name, target in table.items():
            if isinstance(target, dict):  # poetry: {reference = "module:function", type = "console"}
                target = target.get("reference") or target.get("callable")  # noqa: PLW2901
            commands.append((f"{name} = {target}", lines.of(name)))
    points, findings = entry_points(commands)
    setuptools = _table(document, "tool", "setuptools")
    files = setuptools.get("script-files")
    return PythonSide(
        str(project.get("name") or poetry.get("name") or ""),
        points,
        tuple((script, lines.of(script)) for script in files if isinstance(script, str))
        if isinstance(files, list)
        else (),
        tuple((name, folder) for name, folder in _table(setuptools, "package-dir").items() if isinstance(folder, str)),
        findings,
    )


def _table(document: Mapping[str, object], *keys: str) -> dict[str, object]:
    """The table under `keys`, empty where there is none."""
    here: object = document
    for key in keys:
        here = here.get(key) if isinstance(here, dict) else None
    return here if isinstance(here, dict) else {}


def _read_text(path: str, file: str) -> str | Finding:
    data = read_bytes(path, file, limits.DESCRIPTION_FILE)
    if isinstance(data, Finding):
        return Finding("RW008", data.message, data.place)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        return Finding("RW008", "The file is not UTF-8.", Place(file, data.count(b"\n", 0, error.start) + 1))


class _Lines:
    """In which line a declaration stands: found by the whole line, or by what stands before its `=`."""

    def __init__(self, text: str, file: str) -> None:
        self._file = file
        self._numbers: dict[str, int] = {}
        for number, line in enumerate(text.splitlines(), 1):
            for key in (line, line.partition("=")[0], line.partition("=")[2]):
                self._numbers.setdefault(key.strip(" \t,\"'[]"), number)

    def of(self, text: str) -> Place:
        return Place(self._file, self._numbers.get(text.strip(" \t,\"'[]"), 0))
