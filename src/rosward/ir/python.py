# SPDX-License-Identifier: Apache-2.0
"""The operations that only Python has: variables found by name at run time, class bodies, displays, f-strings, imports, `del`, `with`, `yield`.

Their handlers are in `engine/python/transfer.py`. Whatever else a module or a class body names is looked up by name (`LoadGlobal`; in a
class body `LoadName`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, final

from rosward.ir.core import NO_REGISTER, Argument
from rosward.ir.op import Block, Op

if TYPE_CHECKING:
    from rosward.ir.program import Code


@final
class LoadGlobal(Op):
    """dst = the module's variable `name`, else the builtin of that name."""

    __slots__ = ("dst", "name")

    def __init__(self, line: int, column: int, dst: int, name: str) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.name = name


@final
class StoreGlobal(Op):
    """The module's variable `name` = src. `narrowing`: what it holds already, narrowed by an `Assume`; no assignment of the program."""

    __slots__ = ("name", "narrowing", "src")

    def __init__(self, line: int, column: int, name: str, src: int, narrowing: bool = False) -> None:
        super().__init__(line, column)
        self.name = name
        self.src = src
        self.narrowing = narrowing


@final
class LoadName(Op):
    """dst = `name` of the class body being run, else (cell `cell` where not NO_REGISTER, else) the global of that name."""

    __slots__ = ("cell", "dst", "name")

    def __init__(self, line: int, column: int, dst: int, name: str, cell: int = NO_REGISTER) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.name = name
        self.cell = cell


@final
class StoreName(Op):
    """`name` of the class body being run = src."""

    __slots__ = ("name", "src")

    def __init__(self, line: int, column: int, name: str, src: int) -> None:
        super().__init__(line, column)
        self.name = name
        self.src = src


@final
class NewCell(Op):
    """Cell number `cell` becomes a fresh, unbound cell (a comprehension variable that an inner lambda captures)."""

    __slots__ = ("cell",)

    def __init__(self, line: int, column: int, cell: int) -> None:
        super().__init__(line, column)
        self.cell = cell


DeleteKind = Literal["local", "cell", "global", "name", "attr", "item"]
BuildKind = Literal["list", "tuple", "set", "dict"]


@final
class Delete(Op):
    """`del`: kind is 'local' (register obj), 'cell' (cell obj), 'global' / 'name' (name), 'attr' (obj.name) or 'item' (obj[index])."""

    __slots__ = ("index", "kind", "name", "obj")

    def __init__(
        self, line: int, column: int, kind: DeleteKind, obj: int = NO_REGISTER, name: str = "", index: int = NO_REGISTER
    ) -> None:
        super().__init__(line, column)
        self.kind = kind
        self.obj = obj
        self.name = name
        self.index = index


@final
class Build(Op):
    """dst = a new list, tuple, set or dict.

    items are pairs (starred, register); for a dict they are key and value in turn, and a starred item is a mapping to merge
    (one register, no key).
    """

    __slots__ = ("dst", "items", "kind")

    def __init__(self, line: int, column: int, dst: int, kind: BuildKind, items: tuple[tuple[bool, int], ...]) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.kind = kind
        self.items = items


@final
class Format(Op):
    """dst = an f-string: parts are text, or (register, conversion '' | 's' | 'r' | 'a', register of the format spec or NO_REGISTER)."""

    __slots__ = ("dst", "parts")

    def __init__(self, line: int, column: int, dst: int, parts: tuple[str | tuple[int, str, int], ...]) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.parts = parts


@final
class MakeClass(Op):
    """dst = a class; `arguments` are the bases and class keywords, `code` the body (kind 'class'). Decorators are Calls that follow."""

    __slots__ = ("arguments", "captures", "code", "dst")

    def __init__(
        self, line: int, column: int, dst: int, code: Code, arguments: tuple[Argument, ...], captures: tuple[int, ...]
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.code = code
        self.arguments = arguments
        self.captures = captures


@final
class Import(Op):
    """dst = `import module` (the top package, or the module itself where `leaf`, i.e. `import a.b as c`)."""

    __slots__ = ("dst", "leaf", "module")

    def __init__(self, line: int, column: int, dst: int, module: str, leaf: bool) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.module = module
        self.leaf = leaf


@final
class ImportFrom(Op):
    """dst = `from module import name`, `level` leading dots."""

    __slots__ = ("dst", "level", "module", "name")

    def __init__(self, line: int, column: int, dst: int, module: str, level: int, name: str) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.module = module
        self.level = level
        self.name = name


@final
class ImportStar(Op):
    """`from module import *` into the module's variables."""

    __slots__ = ("level", "module")

    def __init__(self, line: int, column: int, module: str, level: int) -> None:
        super().__init__(line, column)
        self.module = module
        self.level = level


@final
class Unpack(Op):
    """dsts = the items of src in order; `star` is the index of the starred target, or NO_REGISTER."""

    __slots__ = ("dsts", "src", "star")

    def __init__(self, line: int, column: int, dsts: tuple[int, ...], star: int, src: int) -> None:
        super().__init__(line, column)
        self.dsts = dsts
        self.star = star
        self.src = src


@final
class Intrinsic(Op):
    """dst = a small primitive of the language, by name, that no other operation says.

    slice(lower, upper, step), append(list, value), set_add(set, value), dict_set(dict, key, value), annotate(class name text, type text),
    is_sequence(v), is_mapping(v), length_is(v, n), length_at_least(v, n), mapping_rest(v, key…), match_args(cls, n) (the tuple of
    attribute names that stand for positional sub-patterns), exception() (the one being handled), doc() (any other constant-like unknown),
    bound(v) (a local variable is read, and v says whether it has a value: UnboundLocalError where it has none),
    isinstance(v, cls), hasattr(v, name), getattr(v, name) (these three as `match` uses them: the builtins, whatever a program calls so),
    unsupported(…) (a construct that the frontend doesn't know; what of it could be lowered stands before).
    """

    __slots__ = ("arguments", "dst", "name")

    def __init__(self, line: int, column: int, dst: int, name: str, arguments: tuple[int, ...]) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.name = name
        self.arguments = arguments


@final
class Yield(Op):
    """dst = yield src; `many` for `yield from`."""

    __slots__ = ("dst", "many", "src")

    def __init__(self, line: int, column: int, dst: int, src: int, many: bool) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src
        self.many = many


@final
class Await(Op):
    """dst = await src."""

    __slots__ = ("dst", "src")

    def __init__(self, line: int, column: int, dst: int, src: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src


@final
class With(Op):
    """Enter the context manager in register context (result to register bind, or NO_REGISTER), run body, leave it."""

    __slots__ = ("bind", "body", "context", "is_async")

    def __init__(self, line: int, column: int, context: int, bind: int, body: Block, is_async: bool = False) -> None:
        super().__init__(line, column)
        self.context = context
        self.bind = bind
        self.body = body
        self.is_async = is_async

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return (self.body,)
