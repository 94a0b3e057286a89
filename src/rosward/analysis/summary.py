# SPDX-License-Identifier: Apache-2.0
"""What must be known of each Python file, also where no process runs it? It is little, and kept, so that what has not changed is not lowered.

creations_of(module, facts)    ->  each read of something that creates an entity, with the function in which it stands
main_calls(module)             ->  the functions that its `__main__` block calls
"""

from __future__ import annotations

from collections.abc import Container, Iterator
from typing import NamedTuple

from rosward.ir import ops
from rosward.ir.op import walk
from rosward.ir.program import Code, Module, OpKey
from rosward.models.facts import LibraryFacts

__all__ = ["Creation", "Summary", "creations_of", "main_calls", "summary_of"]


class Creation(NamedTuple):
    """A read of what creates an entity: `name`, where, and which operation it is; `function`: the key of the function around it."""

    function: str
    file: str
    qualname: str
    name: str
    line: int
    column: int
    op: OpKey


class Summary(NamedTuple):
    """What is known of a file of this content (a digest). `text_lines`: as many lines are told of; `key` is that of the body of the module."""

    content: str
    text_lines: int
    lines: int
    key: str
    imports: frozenset[str]
    first: frozenset[str]
    has_main: bool
    main_calls: frozenset[str]
    created: tuple[Creation, ...]


def summary_of(content: str, text_lines: int, module: Module, facts: LibraryFacts) -> Summary:
    """The summary of a lowered file."""
    return Summary(
        content,
        text_lines,
        module.lines,
        module.code.key,
        module.imports,
        module.first,
        module.has_main,
        frozenset(main_calls(module)) if module.has_main else frozenset(),
        tuple(creations_of(module, facts)),
    )


def creations_of(module: Module, facts: LibraryFacts) -> Iterator[Creation]:
    """What would create an entity, function by function."""
    names = facts.creators_of(name.partition(".")[0] for name in module.imports)
    for code in _functions(module.code):
        for name, op, key in _creations(code, facts.creating, names):
            yield Creation(code.key, code.file, code.qualname, name, op.line, op.column, key)


def creates(code: Code, methods: Container[str]) -> bool:
    """Whether a body reads a method that creates an entity."""
    return any(True for _ in _creations(code, methods, ()))


def _functions(code: Code) -> Iterator[Code]:
    """The code itself and all functions in it."""
    yield code
    for _, op in _all_ops(code):
        if isinstance(op, ops.MakeFunction):
            yield from _functions(op.code)


def _creations(code: Code, methods: Container[str], names: Container[str]) -> Iterator[tuple[str, ops.Op, OpKey]]:
    """The reads of what creates an entity, in nested blocks too but not in functions."""
    called: set[int] = set()
    for body, op in reversed(list(_all_ops(code))):
        if isinstance(op, ops.Call):
            called.add(op.func)
        elif isinstance(op, (ops.LoadAttr, ops.LoadGlobal, ops.LoadName)):
            if (isinstance(op, ops.LoadAttr) and op.name in methods) or (op.dst in called and op.name in names):
                yield op.name, op, (body.key, op.number)


def _all_ops(code: Code) -> Iterator[tuple[Code, ops.Op]]:
    """Every operation of a body and of the bodies of its classes, each with the body that it belongs to."""
    for op in walk(code.ops):
        yield code, op
        if isinstance(op, ops.MakeClass):
            yield from _all_ops(op.code)


def main_calls(module: Module) -> set[str]:
    """The functions that the `__main__` block calls, where it does nothing else; empty where it does more."""
    block = next((op for op in module.code.ops if isinstance(op, ops.If) and op.then and _tests_name(module, op)), None)
    if block is None:
        return set()
    names: set[str] = set()
    for op in block.then:
        if isinstance(op, ops.LoadGlobal):
            names.add(op.name)
        elif not isinstance(op, (ops.Call, ops.LoadAttr, ops.Const)):
            return set()
    return names - {"sys", "exit", "SystemExit"}


def _tests_name(module: Module, wanted: ops.If) -> bool:
    """Whether an `if` of the module tests `__name__`."""
    before: list[ops.Op] = []
    for op in module.code.ops:
        if op is wanted:
            break
        before.append(op)
    return any(isinstance(op, ops.LoadGlobal) and op.name == "__name__" and op.line == wanted.line for op in before)
