# SPDX-License-Identifier: Apache-2.0
"""What is in a class that is derived from list, dict, str, tuple or set? What the builtin holds, and what the class adds.

class Names1(list):
    def joined(self): return "_".join(self)
Names1(["left", "b"]).joined()         ->  'left_b'
"""

from __future__ import annotations

from typing import Final

from ..draft import Draft, Scope, Statement, Way, block
from ..entities import create
from ..values import word

_LIST_METHODS: Final = (
    "    def joined(self):\n        return '_'.join(self)",
    "    def append(self, x):\n        super().append(x + '_ap')\n    def joined(self):\n        return '_'.join(self)",
    "    def __init__(self, *items):\n        super().__init__(x for y in items for x in y)\n        self.extra = len(self)\n    def joined(self):\n        return str(self.extra) + '_'.join(self)",
    "    extra = 'e'\n    def joined(self):\n        return self.extra.join(sorted(self))",
    "    def joined(self):\n        return '_'.join(x for x in self if len(x) > 3) + 'j'",
    "    def extend(self, more):\n        for x in more:\n            self.append('ex_' + x)\n    def joined(self):\n        return '_'.join(self[-2:])",
)


def of_list(draft: Draft, scope: Scope, depth: int) -> str:
    cls, name = draft.fresh("Names"), draft.fresh("names")
    draft.need("import collections")
    base = draft.chooser.pick(["list", "list", "collections.UserList", "collections.deque", "tuple"])
    methods = draft.chooser.pick(_LIST_METHODS)
    if base in {"tuple", "collections.deque", "collections.UserList"}:
        methods = _LIST_METHODS[0]
    draft.define(f"class {cls}({base}):\n{methods}")
    scope.add(f"{name} = {cls}([{word(draft, scope, depth)}, 'item2'])")
    if base != "tuple":
        scope.add(
            draft.chooser.pick(
                [
                    f"{name}.append('three')",
                    f"{name}.extend(['four', 'five'])",
                    f"{name} += ['six']",
                    f"{name}[0] = 'set0'",
                    f"del {name}[0]",
                    f"{name}.insert(0, 'in')",
                ]
            )
        )
    return draft.chooser.pick(
        [
            f"{name}.joined()",
            f"{name}[0]",
            f"{name}[-1]",
            f"'_'.join({name})",
            f"('n' + str(len({name})))",
            f"[*{name}][0]",
            f"sorted({name})[0]",
            f"next(iter({name}))",
        ]
    )


_DICT_METHODS: Final = (
    "    def topic(self):\n        return '_'.join(self.values())",
    "    def __getattr__(self, key):\n        try:\n            return self[key]\n        except KeyError:\n            raise AttributeError(key) from None\n    def topic(self):\n        return self.a",
    "    def __setitem__(self, key, value):\n        super().__setitem__(key, value + '_si')\n    def topic(self):\n        return self['a']",
    "    def __init__(self, *args, **kw):\n        super().__init__(*args, **kw)\n        self['init'] = 'ini'\n    def topic(self):\n        return '_'.join(self)",
    "    def __missing__(self, key):\n        self[key] = key + '_ms'\n        return self[key]\n    def topic(self):\n        return self['z'] + str(len(self))",
    "    def update(self, *args, **kw):\n        super().update(*args, **kw)\n        super().update(up='upd')\n    def topic(self):\n        return '_'.join(sorted(self))",
)


def of_dict(draft: Draft, scope: Scope, depth: int) -> str:
    cls, name = draft.fresh("Table"), draft.fresh("table")
    draft.need("import collections")
    base = draft.chooser.pick(["dict", "dict", "collections.OrderedDict", "collections.UserDict"])
    methods = draft.chooser.pick(_DICT_METHODS)
    if base == "collections.UserDict" and "__getattr__" in methods:
        base = "dict"
    draft.define(f"class {cls}({base}):\n{methods}")
    start = draft.chooser.pick(["({'a': %s, 'b': 'bb'})", "(a=%s, b='bb')", "([('a', %s), ('b', 'bb')])"])
    scope.add(f"{name} = {cls}{start % word(draft, scope, depth)}")
    scope.add(
        draft.chooser.pick(
            [
                "pass",
                f"{name}['c'] = 'cc'",
                f"{name}.update(d='dd')",
                f"{name}.setdefault('e', 'ee')",
                f"{name}.pop('b')",
                f"{name}.update({{'a': 'aa'}})",
            ]
        )
    )
    return draft.chooser.pick(
        [
            f"{name}.topic()",
            f"{name}['a']",
            f"{name}.get('q', 'none')",
            f"'_'.join({name})",
            f"'_'.join({name}.values())",
            f"dict({name})['a']",
            f"{{**{name}}}['a']",
            f"list({name}.items())[-1][0]",
            f"('y' if 'b' in {name} else 'n')",
        ]
    )


_TEXT_METHODS: Final = (
    "    def child(self, x):\n        return type(self)(self + '/' + x)",
    "    suffix = '_sx'\n    def child(self, x):\n        return self + self.suffix + x",
    "    def __truediv__(self, x):\n        return self.__class__(f'{self}_{x}')\n    def child(self, x):\n        return self / x / 'end'",
    "    def upper(self):\n        return 'own_upper'\n    def child(self, x):\n        return self.upper() + x",
    "    def __add__(self, x):\n        return str.__add__(self, '_plus_' + x)\n    def child(self, x):\n        return self + x",
)


def of_text(draft: Draft, scope: Scope, depth: int) -> str:
    cls, name = draft.fresh("Text"), draft.fresh("text")
    draft.define(f"class {cls}(str):\n{draft.chooser.pick(_TEXT_METHODS)}")
    scope.add(f"{name} = {cls}({word(draft, scope, depth)})")
    return draft.chooser.pick(
        [
            f"{name}.child('ch')",
            name,
            f"({name} + '_t')",
            f"f'{{{name}}}_f'",
            f"{name}.upper()",
            f"'_'.join([{name}, 'j'])",
            f"{name}.replace('l', 'r')",
            f"{{{name}: 'hit'}}.get(str({name}), 'no')",
            f"str({name}) + 's'",
        ]
    )


def of_set(draft: Draft, scope: Scope, depth: int) -> str:
    cls, name = draft.fresh("Group"), draft.fresh("group")
    draft.define(
        f"class {cls}({draft.chooser.pick(['set', 'frozenset'])}):\n    def topic(self):\n        return '_'.join(sorted(self))"
    )
    scope.add(f"{name} = {cls}([{word(draft, scope, depth)}, 'b', 'b'])")
    return draft.chooser.pick(
        [
            f"{name}.topic()",
            f"('n' + str(len({name})))",
            f"('y' if 'b' in {name} else 'n')",
            f"'_'.join(sorted({name} | {{'c'}}))",
            f"max({name})",
        ]
    )


# Entities


def made_of_subclass(draft: Draft, scope: Scope, depth: int) -> None:
    """A loop over an object of such a class."""
    cls, inside = draft.fresh("Topics"), scope.inner("x")
    create(draft, inside, depth - 1)
    parts = f"{word(draft, scope, 0)}, 'part2'"
    kind = draft.chooser.number(0, 3)
    if kind == 0:
        draft.define(f"class {cls}(list):\n    pass")
        over = f"{cls}([{parts}])"
    elif kind == 1:
        draft.define(f"class {cls}(dict):\n    def __iter__(self):\n        return iter(sorted(self.keys()))")
        over = draft.chooser.pick(
            [f"{cls}.fromkeys([{parts}])", f"{cls}(p='q', r='s')", f"{cls}(p='q', r='s').values()"]
        )
    elif kind == 2:
        draft.define(
            f"class {cls}(list):\n    def __iter__(self):\n        for x in super().__iter__():\n            yield x + '_it'"
        )
        over = f"{cls}([{parts}])"
    else:
        draft.define(f"class {cls}(list):\n    def add(self, x):\n        self.append(x)\n        return self")
        over = f"{cls}().add({parts.rsplit(', ', maxsplit=1)[-1]}).add('late')"
    scope.add(f"for x in {over}:\n{block(inside.lines)}")


WAYS: Final[tuple[Way, ...]] = (of_list, of_dict, of_text, of_set)
STATEMENTS: Final[tuple[Statement, ...]] = (made_of_subclass,)
