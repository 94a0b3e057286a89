# SPDX-License-Identifier: Apache-2.0
"""What does a `setup.py` declare, read without running it?

    setup(name=package_name, entry_points={"console_scripts": ["talker = " + package_name + ".talker:main"]})
    ->  Declared(name="demo", entry_points=(EntryPoint("talker", "demo.talker", "main"),))

Constants, names bound to them, texts built of them and comprehensions over them are understood. What is there but
cannot be told becomes a finding (RW008), not silence.
"""

from __future__ import annotations

import ast
import os
import sys
import warnings
from collections import Counter
from typing import TYPE_CHECKING, Any, Final

from rosward.findings import Finding
from rosward.location import Place
from rosward.source import limits
from rosward.source.entry_points import PythonSide, entry_points, text_lines
from rosward.source.glob import glob
from rosward.source.literal import UNKNOWN, LiteralScope, bind, evaluate
from rosward.source.surroundings import ROS_2
from rosward.source.text import decode, read_bytes

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

_COMMANDS: Final = ("console_scripts", "gui_scripts")


def read_setup_py(path: str, file: str, environment: Mapping[str, str] = ROS_2) -> PythonSide:
    """What the `setup.py` at `path`, called `file`, declares where these environment variables are set."""
    data = read_bytes(path, file, limits.DESCRIPTION_FILE)
    source = data if isinstance(data, Finding) else decode(data, file)
    if isinstance(source, Finding):
        return PythonSide(findings=(Finding("RW008", source.message, source.place),))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(source.text)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        line = getattr(error, "lineno", None) or 0
        message = f"The setup.py is not Python {sys.version_info[0]}: {error}."
        return PythonSide(findings=(Finding("RW008", message, Place(file, line)),))
    try:
        return _SetupScript(path, file, environment).read(tree)
    except RecursionError:
        return PythonSide(findings=(Finding("RW008", "The setup.py is nested too deeply.", Place(file)),))


class _SetupScript:
    """One `setup.py` in the course of being read."""

    def __init__(self, path: str, file: str, environment: Mapping[str, str]) -> None:
        self._file = file
        self._folder = os.path.dirname(path)  # noqa: PTH120
        self._scope = LiteralScope({"__name__": "__main__"}, glob=self._glob, environment=environment)
        self._lines: dict[str, int] = {}
        self._findings: list[Finding] = []
        self._generated: list[tuple[str, str, str, Place]] = []
        self._stores: Counter[str] = Counter()
        """How often each name is assigned."""

    def read(self, tree: ast.Module) -> PythonSide:
        for node in ast.walk(tree):
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                self._stores[node.id] += 1
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                self._lines.setdefault(node.value, node.lineno)
                if "=" in node.value:  # 'talker = ' + package + '.talker:main'
                    self._lines.setdefault(_head(node.value), node.lineno)
        result = PythonSide()
        for call in self._calls(tree.body):
            result |= self._setup(call)
        return result._replace(
            findings=result.findings + tuple(self._findings), generated=tuple(dict.fromkeys(self._generated))
        )

    def _glob(self, pattern: str, recursive: bool) -> Any:
        found = glob(self._folder, pattern, recursive=recursive)
        return UNKNOWN if found is None else found

    def _calls(self, body: list[ast.stmt]) -> Iterator[ast.Call]:
        """The calls of `setup` in the order of the text, with the names bound that stand before them."""
        for statement in body:
            if not self._scope.step():
                return
            match statement:
                case ast.Assign(targets=targets, value=value):
                    if isinstance(value, ast.Call) and _is_setup(value):
                        yield value
                    result = evaluate(value, self._scope)
                    for target in targets:
                        self._assign(target, result)
                case ast.AnnAssign(target=target, value=ast.expr() as value):
                    self._assign(target, evaluate(value, self._scope))
                case ast.AugAssign(target=ast.Name() as name, op=ast.Add() as op, value=value):
                    self._scope.bind(name.id, evaluate(ast.BinOp(ast.Name(name.id), op, value), self._scope))
                case ast.Expr(value=ast.Call() as call):
                    if _is_setup(call):
                        yield call
                    if _called(call) == "generate_parameter_module":
                        self._generate(call)
                    self._grow(call)
                case ast.For(target=target, iter=iterable, body=inner):
                    items = evaluate(iterable, self._scope)
                    for item in items[:1000] if isinstance(items, list | tuple) else [UNKNOWN]:
                        bind(target, item, self._scope)
                        yield from self._calls(inner)
                case ast.If(test=test):
                    decided = self._decided(test)
                    yield from self._calls([] if decided is False else statement.body)
                    yield from self._calls([] if decided is True else statement.orelse)
                case ast.While():
                    yield from self._calls([*statement.body, *statement.orelse])
                case ast.Try():
                    yield from self._calls([*statement.body, *statement.orelse, *statement.finalbody])
                case ast.With() | ast.FunctionDef():
                    yield from self._calls(statement.body)
                case _:
                    pass

    def _decided(self, test: ast.expr) -> bool | None:
        """Whether a test is surely true: on plain values that no other statement may have changed. None: both ways are read."""
        value = evaluate(test, self._scope)
        if not isinstance(value, str | int | float | None):
            return None
        for node in ast.walk(test):
            if isinstance(node, ast.Name) and self._stores[node.id]:
                plain = isinstance(evaluate(node, self._scope), str | int | float | None)
                if not plain or self._stores[node.id] > 1:
                    return None
        return bool(value)

    def _assign(self, target: ast.expr, value: Any) -> None:
        if isinstance(target, ast.Subscript):
            owner, key = evaluate(target.value, self._scope), evaluate(target.slice, self._scope)
            if isinstance(owner, dict):
                owner[key] = value
        else:
            bind(target, value, self._scope)

    def _grow(self, call: ast.Call) -> None:
        """`commands.append(x)`, `commands.extend(xs)`, `options.update(xs)` on a known container."""
        if not isinstance(call.func, ast.Attribute) or len(call.args) != 1:
            return
        owner, value = evaluate(call.func.value, self._scope), evaluate(call.args[0], self._scope)
        match call.func.attr:
            case "append" if isinstance(owner, list):
                owner.append(value)
            case "extend" if isinstance(owner, list):
                owner.extend(list(value) if isinstance(value, list | tuple) else [UNKNOWN])
            case "update" if isinstance(owner, dict):
                owner.update(dict(value) if isinstance(value, dict) else {UNKNOWN: UNKNOWN})
            case _:
                pass

    def _generate(self, call: ast.Call) -> None:
        """`generate_parameter_module(module_name, yaml_file, validation_module="")` of generate_parameter_library_py."""
        given = dict(zip(("module_name", "yaml_file", "validation_module"), call.args, strict=False))
        given |= {keyword.arg: keyword.value for keyword in call.keywords if keyword.arg}
        name, source = (evaluate(given.get(key), self._scope) for key in ("module_name", "yaml_file"))
        validation = evaluate(given["validation_module"], self._scope) if "validation_module" in given else ""
        if isinstance(name, str) and isinstance(source, str) and isinstance(validation, str):
            self._generated.append((name, source, validation, Place(self._file, call.lineno)))
        else:
            self._doubt("arguments of generate_parameter_module()", call.lineno)

    def _setup(self, call: ast.Call) -> PythonSide:
        keywords: dict[str, tuple[Any, int]] = {}
        for keyword in call.keywords:
            value = evaluate(keyword.value, self._scope)
            if keyword.arg is not None:
                keywords[keyword.arg] = (value, keyword.value.lineno)
            elif isinstance(value, dict):  # setup(**options)
                keywords.update({key: (item, call.lineno) for key, item in value.items() if isinstance(key, str)})
            if keyword.arg is None and (not isinstance(value, dict) or UNKNOWN in value):
                self._doubt("arguments of setup()", call.lineno)
        name, _ = keywords.get("name", ("", 0))
        folders, line = keywords.get("package_dir", ({}, 0))
        if not isinstance(folders, dict):
            self._doubt("package_dir", line)
            folders = {}
        data = list(self._data_files(*keywords.get("data_files", ([], 0))))
        points, findings = entry_points(self._commands(*keywords.get("entry_points", ({}, 0))))
        self._findings += findings
        return PythonSide(
            name if isinstance(name, str) else "",
            points,
            tuple(self._texts("scripts", *keywords.get("scripts", ([], 0)))),
            tuple((k, v) for k, v in folders.items() if isinstance(k, str) and isinstance(v, str)),
            data_files=tuple(each for each in data if each is not None),
            all_data=None not in data,
        )

    def _data_files(self, value: Any, line: int) -> Iterator[tuple[str, str, Place] | None]:
        """Where each file is installed, and the file; None for what cannot be told."""
        for entry in value if isinstance(value, list | tuple) else [UNKNOWN]:
            match entry:
                case (str() as folder, list() | tuple() as files):
                    for file in files:
                        if isinstance(file, str):
                            where = self._lines.get(file) or self._lines.get(folder, line)
                            target = f"{folder.rstrip('/')}/{file.rpartition('/')[2]}"
                            yield target, file, Place(self._file, where)
                        else:
                            yield None
                case _:
                    yield None

    def _commands(self, value: Any, line: int) -> Iterator[tuple[str, Place]]:
        if isinstance(value, str):  # the form of an INI file
            value = _sections(value)
        if not isinstance(value, dict):
            if value is not None:
                self._doubt("entry_points", line)
            return
        if UNKNOWN in value:
            self._doubt("entry_points", line)
        for kind in _COMMANDS:
            yield from self._texts(kind, value.get(kind) or [], line)

    def _texts(self, what: str, value: Any, line: int) -> Iterator[tuple[str, Place]]:
        if isinstance(value, str):
            value = text_lines(value)
        if not isinstance(value, list | tuple):
            self._doubt(what, line)
            return
        if any(not isinstance(item, str) for item in value):
            self._doubt(f"{what} (some of them)", line)
        for item in value:
            if isinstance(item, str):
                yield item, Place(self._file, self._lines.get(item) or self._lines.get(_head(item), line))

    def _doubt(self, what: str, line: int) -> None:
        message = f"The {what} in setup.py cannot be determined without running it. Write them as constants."
        self._findings.append(Finding("RW008", message, Place(self._file, line)))


def _head(command: str) -> str:
    return command.partition("=")[0].strip() + " ="


def _is_setup(call: ast.Call) -> bool:
    """Whether this calls `setup`, `setuptools.setup` or `distutils.core.setup`."""
    called = call.func
    return (isinstance(called, ast.Name) and called.id == "setup") or (
        isinstance(called, ast.Attribute)
        and called.attr == "setup"
        and isinstance(called.value, ast.Name | ast.Attribute)
    )


def _called(call: ast.Call) -> str:
    """The last part of the name of what is called."""
    called = call.func
    return called.id if isinstance(called, ast.Name) else called.attr if isinstance(called, ast.Attribute) else ""


def _sections(text: str) -> dict[str, list[str]]:
    """`[console_scripts]\\na = b:c` as a dictionary."""
    sections: dict[str, list[str]] = {}
    current: list[str] = []
    for line in text_lines(text):
        if line.startswith("[") and line.endswith("]"):
            current = sections.setdefault(line[1:-1].strip(), [])
        else:
            current.append(line)
    return sections
