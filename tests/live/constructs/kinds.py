# SPDX-License-Identifier: Apache-2.0
"""What is something an instance of? Protocols, registered classes, the abstract ones of Python, unions and tuples.

@runtime_checkable
class Named1(Protocol):
    def name(self): ...
isinstance(Thing1("left"), Named1)     decided by the methods that Thing1 has
"""

from __future__ import annotations

from typing import Final

from ..draft import Draft, Scope, Statement, Way, block
from ..entities import create
from ..values import word

_OBJECTS: Final = (
    *("'text'", "3", "True", "2.5", "None", "[1]", "(1,)", "{'a': 1}", "{1}", "b'x'", "len", "print", "str"),
    *("range(2)", "iter([])", "(x for x in 'a')", "lambda: 1", "dict().items()", "object()", "type", "NotImplemented"),
    *("collections.OrderedDict()", "collections.deque()", "collections.UserDict()", "frozenset()", "ValueError()"),
)
_KINDS: Final = (
    *("str", "int", "float", "bool", "list", "tuple", "dict", "set", "bytes", "type", "object", "type(None)"),
    *("(str, int)", "int | str", "(list, (tuple, str))", "str | None", "(int, float) + (str,)"),
    *("collections.abc.Iterable", "collections.abc.Iterator", "collections.abc.Sequence", "collections.abc.Mapping"),
    *("collections.abc.Callable", "collections.abc.Hashable", "collections.abc.Sized", "collections.abc.Container"),
    *("collections.abc.MutableSequence", "collections.abc.Set", "collections.abc.Generator", "numbers.Number"),
    *("numbers.Integral", "numbers.Real", "Exception", "collections.abc.Collection"),
)


def of_python(draft: Draft, scope: Scope, depth: int) -> str:
    """A value of Python's own and a class of Python's own."""
    draft.need("import collections, collections.abc, numbers")
    one, two = word(draft, scope, depth), word(draft, scope, 0)
    test = f"isinstance({draft.chooser.pick(_OBJECTS)}, {draft.chooser.pick(_KINDS)})"
    if draft.chooser.chance(20):
        test = f"issubclass({draft.chooser.pick(['bool', 'str', 'dict', 'list'])}, {draft.chooser.pick(_KINDS)})"
    return f"({one} if {test} else {two} + '_not')"


_DEFINED: Final = (
    "    def name(self):\n        return 'n'",
    "    name = 'attribute'",
    "    def __init__(self):\n        self.name = 'own'",
    "    def __iter__(self):\n        return iter(())",
    "    def __call__(self):\n        return 1",
    "    def __len__(self):\n        return 1\n    def __getitem__(self, i):\n        return i",
    "    def __getattr__(self, key):\n        if key.startswith('_'):\n            raise AttributeError(key)\n        return key",
    "    __hash__ = None",
    "    def __enter__(self):\n        return self\n    def __exit__(self, *args):\n        return None",
    "    pass",
)


def thing(draft: Draft) -> tuple[str, str]:
    """Define a class with some methods and one that it may be an instance of; their names."""
    cls, other = draft.fresh("Item"), draft.fresh("Sort")
    draft.need("import abc, collections, collections.abc, contextlib, numbers")
    draft.need("from typing import Protocol, runtime_checkable")
    draft.define(f"class {cls}:\n{draft.chooser.pick(_DEFINED)}")
    asked = draft.chooser.pick(["name", "__iter__", "__call__", "__len__", "other"])
    kind = draft.chooser.number(0, 7)
    if kind <= 1:
        member = f"    def {asked}(self): ..." if draft.chooser.chance(70) else f"    {asked}: str"
        draft.define(f"@runtime_checkable\nclass {other}(Protocol):\n{member}")
    elif kind == 2:
        draft.define(f"class {other}(abc.ABC):\n    pass")
        if draft.chooser.chance(60):
            draft.define(f"{other}.register({cls})")
    elif kind == 3:
        draft.define(f"class {other}(abc.ABC):\n    pass\n\n\n@{other}.register\nclass {cls}Sub({cls}):\n    pass")
        cls = draft.chooser.pick([cls, f"{cls}Sub"])
    elif kind == 4:
        draft.define(
            f"class {other}(abc.ABC):\n    @classmethod\n    def __subclasshook__(cls, kind):\n"
            f"        return hasattr(kind, {asked!r}) or NotImplemented"
        )
    elif kind == 5:
        draft.define(f"class {other}({cls}):\n    pass")
    elif kind == 6:
        draft.define(f"class {cls}Low({cls}):\n    pass")
        other, cls = cls, f"{cls}Low"
    else:
        known = ("Iterable", "Callable", "Hashable", "Sized", "Sequence", "Container")
        other = "collections.abc." + draft.chooser.pick(known)
        if other.endswith("Sequence") and draft.chooser.chance(50):
            draft.define(f"{other}.register({cls})")
    return cls, other


def of_own(draft: Draft, scope: Scope, depth: int) -> str:
    """A class of the program's own, and one that asks for methods, was told of it, or is its base."""
    cls, other = thing(draft)
    one, two = word(draft, scope, depth), word(draft, scope, 0)
    test = draft.chooser.pick(
        [
            f"isinstance({cls}(), {other})",
            f"isinstance({cls}(), (str, {other}))",
            f"isinstance({cls}(), {other} | None)",
        ]
    )
    return f"({one} if {test} else {two} + '_not')"


def dispatched(draft: Draft, scope: Scope, depth: int) -> str:
    """A function that is chosen by the class of its argument: singledispatch, match, tables of types."""
    function, cls = draft.fresh("dispatch"), thing(draft)[0]
    value = draft.chooser.pick([word(draft, scope, depth), "3", "True", f"{cls}()", "['li']", "None", "2.5"])
    kind = draft.chooser.number(0, 2)
    if kind == 0:
        draft.need("import functools")
        draft.define(
            f"@functools.singledispatch\ndef {function}(a):\n    return 'any'\n\n\n@{function}.register\ndef _(a: str):\n    return a + '_text'\n\n\n"
            f"@{function}.register(int)\ndef _(a):\n    return 'int' + str(a + 0)\n\n\n@{function}.register({cls})\ndef _(a):\n    return 'own'"
        )
    elif kind == 1:
        draft.define(
            f"def {function}(a):\n    match a:\n        case bool():\n            return 'truth'\n        case int() | float():\n            return 'number'\n"
            f"        case str() as text:\n            return text + '_m'\n        case {cls}():\n            return 'own'\n"
            "        case [first, *_]:\n            return first + '_s'\n        case _:\n            return 'rest'"
        )
    else:
        draft.define(
            f"{function}_table = {{str: 'text', int: 'int', bool: 'truth', {cls}: 'own'}}\n\n\ndef {function}(a):\n"
            f"    for kind in type(a).__mro__:\n        if kind in {function}_table:\n            return {function}_table[kind]\n    return 'none'"
        )
    return f"{function}({value})"


# Entities


def made_for_kind(draft: Draft, scope: Scope, depth: int) -> None:
    """Entities for what is an instance, others for what is not."""
    cls, other = thing(draft)
    one, two = scope.inner(), scope.inner()
    create(draft, one, depth - 1)
    create(draft, two, 0)
    scope.add(f"if isinstance({cls}(), {other}):\n{block(one.lines)}\nelse:\n{block(two.lines)}")


WAYS: Final[tuple[Way, ...]] = (of_python, of_own, of_own, dispatched)
STATEMENTS: Final[tuple[Statement, ...]] = (made_for_kind,)
