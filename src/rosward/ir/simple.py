# SPDX-License-Identifier: Apache-2.0
"""The operations that run straight on: they read registers and write at most one.

Law: every concrete class is final and pure data; a variant is a field; so `type(op)` decides everything.
An operation reads registers (small integers, local to one `Code`) and writes at most one, `dst`. Control flow is structured:
the control operations hold blocks, and a block is a list of operations that run in order.

    x = a.b + 1          LoadGlobal r1 'a'; LoadAttr r2 r1 'b'; Const r3 1; Binary r0 + r2 r3

Names are resolved when lowering: a local variable is a register, a variable shared with an inner function is a cell (numbered per
`Code`), everything else is looked up by name (`LoadGlobal`; in a class body `LoadName`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, final

if TYPE_CHECKING:
    from rosward.ir.program import Code

Constant = None | bool | int | float | complex | str | bytes
"""What a `Const` can hold; `...` is the global name `Ellipsis`."""


class Op:
    """An operation; `line` and `column` (both from 1) say where in the source it stands, `number` (from 1) which one of its `Code` it is.

    Several operations may stand at one place (`f(f(x))`, `a().b()`), so a place does not tell them apart; the number does.
    """

    __slots__ = ("column", "line", "number")

    def __init__(self, line: int, column: int) -> None:
        self.line = line
        self.column = column
        self.number = 0  # given when the code is complete

    @property
    def blocks(self) -> tuple[Block, ...]:
        """The blocks that it holds, in the order in which they stand."""
        return ()


Block = list[Op]

NO_REGISTER: Final = -1


@final
class Const(Op):
    """dst = value."""

    __slots__ = ("dst", "value")

    def __init__(self, line: int, column: int, dst: int, value: Constant) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.value = value


@final
class Move(Op):
    """dst = src."""

    __slots__ = ("dst", "src")

    def __init__(self, line: int, column: int, dst: int, src: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src


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
class LoadCell(Op):
    """dst = cell number `cell` of this `Code` (own cells first, then free ones)."""

    __slots__ = ("cell", "dst")

    def __init__(self, line: int, column: int, dst: int, cell: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.cell = cell


@final
class StoreCell(Op):
    """Cell number `cell` = src. `narrowing`: what it holds already, narrowed by an `Assume`; no assignment of the program."""

    __slots__ = ("cell", "narrowing", "src")

    def __init__(self, line: int, column: int, cell: int, src: int, narrowing: bool = False) -> None:
        super().__init__(line, column)
        self.cell = cell
        self.src = src
        self.narrowing = narrowing


@final
class NewCell(Op):
    """Cell number `cell` becomes a fresh, unbound cell (a comprehension variable that an inner lambda captures)."""

    __slots__ = ("cell",)

    def __init__(self, line: int, column: int, cell: int) -> None:
        super().__init__(line, column)
        self.cell = cell


@final
class LoadAttr(Op):
    """dst = obj.name."""

    __slots__ = ("dst", "name", "obj")

    def __init__(self, line: int, column: int, dst: int, obj: int, name: str) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.obj = obj
        self.name = name


@final
class StoreAttr(Op):
    """obj.name = src.

    `narrowing`: what the instance holds already, narrowed by an `Assume`; no assignment of the program, so that no property or
    `__setattr__` runs. Of a property that only returns an attribute of the instance, that is narrowed; nothing happens where the instance
    itself has no such attribute (a method, a class attribute).
    """

    __slots__ = ("name", "narrowing", "obj", "src")

    def __init__(self, line: int, column: int, obj: int, name: str, src: int, narrowing: bool = False) -> None:
        super().__init__(line, column)
        self.obj = obj
        self.name = name
        self.src = src
        self.narrowing = narrowing


@final
class LoadItem(Op):
    """dst = obj[index]; a slice is made by the `slice` intrinsic first."""

    __slots__ = ("dst", "index", "obj")

    def __init__(self, line: int, column: int, dst: int, obj: int, index: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.obj = obj
        self.index = index


@final
class StoreItem(Op):
    """obj[index] = src. `narrowing`: what a list or dict holds already, narrowed by an `Assume`; no assignment of the program."""

    __slots__ = ("index", "narrowing", "obj", "src")

    def __init__(self, line: int, column: int, obj: int, index: int, src: int, narrowing: bool = False) -> None:
        super().__init__(line, column)
        self.obj = obj
        self.index = index
        self.src = src
        self.narrowing = narrowing


@final
class Delete(Op):
    """`del`: kind is 'local' (register obj), 'cell' (cell obj), 'global' / 'name' (name), 'attr' (obj.name) or 'item' (obj[index])."""

    __slots__ = ("index", "kind", "name", "obj")

    def __init__(
        self, line: int, column: int, kind: str, obj: int = NO_REGISTER, name: str = "", index: int = NO_REGISTER
    ) -> None:
        super().__init__(line, column)
        self.kind = kind
        self.obj = obj
        self.name = name
        self.index = index


@final
class Unary(Op):
    """dst = operator src; operator is one of `not - + ~`."""

    __slots__ = ("dst", "operator", "src")

    def __init__(self, line: int, column: int, dst: int, operator: str, src: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.operator = operator
        self.src = src


@final
class Binary(Op):
    """dst = left operator right; `inplace` for the augmented assignment."""

    __slots__ = ("dst", "inplace", "left", "operator", "right")

    def __init__(
        self, line: int, column: int, dst: int, operator: str, left: int, right: int, inplace: bool = False
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.operator = operator
        self.left = left
        self.right = right
        self.inplace = inplace


@final
class Compare(Op):
    """dst = left operator right; operator is one of `== != < <= > >= is is-not in not-in`. Chains are lowered to several."""

    __slots__ = ("dst", "left", "operator", "right")

    def __init__(self, line: int, column: int, dst: int, operator: str, left: int, right: int) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.operator = operator
        self.left = left
        self.right = right


@final
class Argument:
    """One argument as written: kind is 'positional', 'star', 'keyword' (with its name) or 'doublestar'."""

    __slots__ = ("kind", "name", "register")

    def __init__(self, kind: str, register: int, name: str = "") -> None:
        self.kind = kind
        self.register = register
        self.name = name


@final
class Call(Op):
    """dst = func(arguments…). `simple` holds the registers where all arguments are positional, else None."""

    __slots__ = ("arguments", "dst", "func", "simple")

    def __init__(self, line: int, column: int, dst: int, func: int, arguments: tuple[Argument, ...]) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.func = func
        self.arguments = arguments
        simple = all(a.kind == "positional" for a in arguments)
        self.simple: tuple[int, ...] | None = tuple(a.register for a in arguments) if simple else None


@final
class Build(Op):
    """dst = a new list, tuple, set or dict.

    items are pairs (starred, register); for a dict they are key and value in turn, and a starred item is a mapping to merge
    (one register, no key).
    """

    __slots__ = ("dst", "items", "kind")

    def __init__(self, line: int, column: int, dst: int, kind: str, items: tuple[tuple[bool, int], ...]) -> None:
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
class MakeFunction(Op):
    """dst = a function object; defaults are registers for the last positional parameters, kwdefaults pairs (name, register).

    `captures` gives, for each free cell of `code`, the number of the cell in the enclosing code.
    """

    __slots__ = ("captures", "code", "defaults", "dst", "kwdefaults")

    def __init__(
        self,
        line: int,
        column: int,
        dst: int,
        code: Code,
        defaults: tuple[int, ...],
        kwdefaults: tuple[tuple[str, int], ...],
        captures: tuple[int, ...],
    ) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.code = code
        self.defaults = defaults
        self.kwdefaults = kwdefaults
        self.captures = captures


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
class Assume(Op):
    """Narrow register src to the values for which `test` holds (where `sense`) or does not; nothing left: the path is dead.

    test is 'true' (truthiness), 'is', '==' or 'in' against register `other`, or 'isinstance' with the class in `other`.
    The result is written to dst.
    """

    __slots__ = ("dst", "other", "sense", "src", "test")

    def __init__(self, line: int, column: int, dst: int, src: int, test: str, other: int, sense: bool) -> None:
        super().__init__(line, column)
        self.dst = dst
        self.src = src
        self.test = test
        self.other = other
        self.sense = sense


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
