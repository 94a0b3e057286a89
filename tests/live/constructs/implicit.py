# SPDX-License-Identifier: Apache-2.0
"""Which methods does Python call without a call in the source? Every special method, with what triggers it.

class Implicit1:
    def __format__(self, how): return self.a + how
f"{Implicit1('left'):x}"               ->  'leftx'
"""

from __future__ import annotations

from typing import Final, NamedTuple

from ..draft import Draft, Scope, Statement, Way, block
from ..entities import creation
from ..values import word


class Trigger(NamedTuple):
    """A special method: its parameters, what it returns, and expressions over `{o}`, an object, that call it.

    Each expression gives something of which `str(…)` is a word. `{w}` is another word, `{c}` the class.
    """

    method: str
    parameters: str
    result: str
    used: tuple[str, ...]
    base: str = ""


_TRIGGERS: Final = (
    Trigger(
        "__str__",
        "",
        "self.a + '_str'",
        ("str({o})", "f'{{{o}}}'", "'%s' % {o}", "'{{}}'.format({o})", "'_'.join(map(str, [{o}]))"),
    ),
    Trigger("__repr__", "", "self.a + '_repr'", ("repr({o})", "str({o})", "f'{{{o}!r}}'", "'%r' % {o}")),
    Trigger(
        "__format__",
        ", how",
        "self.a + how",
        ("f'{{{o}:fx}}'", "format({o}, 'fy')", "'{{:fz}}'.format({o})", "f'{{{o}}}'"),
    ),
    Trigger(
        "__len__", "", "len(self.a)", ("len({o})", "bool({o})", "('y' if {o} else 'n')", "('e' if not {o} else 'f')")
    ),
    Trigger(
        "__bool__",
        "",
        "self.a == 'left'",
        ("bool({o})", "('y' if {o} else 'n')", "({o} and 'and')and 'z'", "any([{o}])"),
    ),
    Trigger("__int__", "", "len(self.a)", ("int({o})",)),
    Trigger(
        "__index__",
        "",
        "len(self.a) % 3",
        ("['p', 'q', 'r'][{o}]", "len(range({o}))", "'abc'[{o}]", "hex({o})", "['p', 'q', 'r', 's'][{o}:][0]"),
    ),
    Trigger("__hash__", "", "hash(len(self.a))", ("{{{o}: 'h'}} and 'k'", "len({{{o}, 'x'}})")),
    Trigger(
        "__eq__",
        ", other",
        "self.a == getattr(other, 'a', other)",
        ("({o} == {w})", "({w} == {o})", "({o} in [{w}, 'left'])", "['left', {w}].count({o})", "({o} != 'left')"),
    ),
    Trigger(
        "__lt__",
        ", other",
        "self.a[::-1] < other.a[::-1]",
        (
            "sorted([{o}, {c}('mid'), {c}('q')])[0].a",
            "min({o}, {c}('zz')).a",
            "max([{o}, {c}('aa')]).a",
            "({o} < {c}('m'))",
        ),
    ),
    Trigger("__gt__", ", other", "len(self.a) > 3", ("({o} > {c}('m'))", "max({c}('aa'), {o}).a", "({c}('m') < {o})")),
    Trigger("__le__", ", other", "len(self.a) <= 4", ("({o} <= {c}('m'))", "({c}('m') >= {o})")),
    Trigger(
        "__call__",
        ", b='cb'",
        "self.a + b",
        ("{o}()", "{o}('d')", "list(map({o}, ['m']))[0]", "(lambda f: f())({o})", "max(['a'], key={o})"),
    ),
    Trigger(
        "__iter__",
        "",
        "iter([self.a, 'two'])",
        (
            "'_'.join({o})",
            "list({o})[1]",
            "[*{o}][0]",
            "next(iter({o}))",
            "sorted({o})[0]",
            "('two' in {o})",
            "dict(enumerate({o}))[0]",
            "(lambda a, b: b + a)(*{o})",
            "max({o})",
            "list(zip({o}, 'xy'))[0][0]",
            "{{**dict.fromkeys({o}, 'v')}}['two']",
        ),
    ),
    Trigger("__reversed__", "", "iter(['r', self.a])", ("'_'.join(reversed({o}))", "list(reversed({o}))[1]")),
    Trigger("__contains__", ", item", "item in self.a", ("({w} in {o})", "('x' not in {o})")),
    Trigger(
        "__getitem__",
        ", key",
        "(self.a, 'gi', 'gj')[key] if isinstance(key, int) else self.a + str(key)",
        ("{o}[0]", "{o}['k']", "[*{o}][1]", "('gi' in {o})", "next(iter({o}))"),
    ),
    Trigger(
        "__getattr__",
        ", name",
        "name + '_' + str(len(name))",
        ("{o}.anything", "getattr({o}, 'other', 'd')", "hasattr({o}, 'more')", "{o}.a"),
    ),
    Trigger(
        "__add__",
        ", other",
        "self.a + '_add_' + str(other)",
        ("({o} + 'x')", "({o} + {w})", "functools.reduce(lambda a, b: a + b, [{o}, 'z'])"),
    ),
    Trigger("__radd__", ", other", "str(other) + '_radd_' + self.a", ("('x' + {o})", "({w} + {o})", "sum([{o}])")),
    Trigger("__mul__", ", other", "self.a * other", ("({o} * 2)",)),
    Trigger("__rmul__", ", other", "self.a * other", ("(2 * {o})",)),
    Trigger("__truediv__", ", other", "self.a + '/' + str(other)", ("({o} / 'x')", "({o} / {w})")),
    Trigger("__or__", ", other", "self.a + '_or'", ("({o} | 'x')",)),
    Trigger("__matmul__", ", other", "self.a + '_at'", ("({o} @ 'x')",)),
    Trigger("__neg__", "", "'neg_' + self.a", ("(-{o})",)),
    Trigger("__invert__", "", "'inv_' + self.a", ("(~{o})",)),
    Trigger("__abs__", "", "'abs_' + self.a", ("abs({o})",)),
    Trigger("__round__", ", digits=0", "'round_' + self.a", ("round({o})", "round({o}, 2)")),
    Trigger("__fspath__", "", "self.a + '_fs'", ("os.fspath({o})", "os.path.join('d', {o})", "os.path.basename({o})")),
    Trigger(
        "__missing__",
        ", key",
        "key + '_missing'",
        (
            "{o}['none']",
            "{o}.get('none', 'got')",
            "('none' in {o})",
            "({o}['p'] + {o}['q'])",
            "'{{m}}'.format_map({o})",
        ),
        "dict",
    ),
    Trigger(
        "__setitem__",
        ", key, value",
        "super().__setitem__(key + '_set', value)",
        (
            "'_'.join([k for k in {o}] or ['no'])",
            "({o}.update(u={w}) or '_'.join({o}))",
            "({o}.setdefault('d', 'e') + '_'.join({o}))",
            "'_'.join({{**{o}, 'v': 'w'}})",
        ),
        "dict",
    ),
    Trigger(
        "__setitem__",
        ", key, value",
        "super().__setitem__(key + '_set', value)",
        ("({o}.update(u={w}) or '_'.join({o}))", "({o}.setdefault('d', 'e') or '') and '_'.join({o})"),
        "collections.UserDict",
    ),
    Trigger("__len__", "", "2", ("len({o})", "[*{o}, 'x'][0]", "bool({o})"), "list"),
    Trigger(
        "__iter__",
        "",
        "iter(['over', 'iter'])",
        ("'_'.join({o})", "[x for x in {o}][0]", "list({o})[1]", "max({o})"),
        "list",
    ),
    Trigger("__contains__", ", item", "len(item) > 3", ("({w} in {o})", "('abc' in {o})"), "list"),
    Trigger("__getitem__", ", key", "'at_' + str(key)", ("{o}[0]", "{o}[7]", "'_'.join([*{o}, 'e'])"), "list"),
    Trigger("__str__", "", "'own_str'", ("str({o})", "f'{{{o}}}'", "'_'.join(['a', {o}])", "({o} + 'x')"), "str"),
    Trigger(
        "__add__",
        ", other",
        "'own_add_' + other",
        ("({o} + 'x')", "f'{{{o}}}_f'", "''.join([{o}, 'x'])", "{o}.upper()"),
        "str",
    ),
    Trigger("__eq__", ", other", "True", ("({o} == 'x')", "('x' == {o})", "({o} in ['q'])"), "int"),
    Trigger("__mul__", ", other", "'times_' + str(other)", ("({o} * 3)", "({o} + 3)", "'n%d' % {o}"), "int"),
)


def special(draft: Draft, scope: Scope, depth: int) -> str:
    """A word that a special method makes."""
    trigger = draft.chooser.pick(_TRIGGERS)
    cls, made = draft.fresh("Implicit"), draft.fresh("imp")
    draft.need("import collections, functools, os")
    start = "    def __init__(self, a):\n        self.a = a\n"
    filled = {"": "{t}", "dict": "{t}", "collections.UserDict": "{t}", "list": "{t}", "str": "{t}", "int": "{t}"}[
        trigger.base
    ]
    argument = word(draft, scope, depth)
    if trigger.base in {"dict", "collections.UserDict"}:
        start, argument = "", f"{{'given': {argument}}}"
    elif trigger.base == "list":
        start, argument = "", f"[{argument}, 'item2']"
    elif trigger.base == "str":
        start = ""
    elif trigger.base == "int":
        start, argument = "", f"len({argument})"
    base = f"({trigger.base})" if trigger.base else ""
    hashed = "    __hash__ = object.__hash__\n" if trigger.method == "__eq__" else ""
    draft.define(
        f"class {cls}{base}:\n{start}{hashed}    def {trigger.method}(self{trigger.parameters}):\n        return {trigger.result}"
    )
    scope.add(f"{made} = {cls}({filled.format(t=argument)})")
    if draft.chooser.chance(20):
        draft.define(f"class {cls}Sub({cls}):\n    pass")
        scope.add(f"{made} = {cls}Sub({argument})")
    used = draft.chooser.pick(trigger.used).format(o=made, c=cls, w=word(draft, scope, 0))
    return f"str({used})"


def descriptor(draft: Draft, scope: Scope, depth: int) -> str:
    """Attributes that are functions: descriptors, with their owner's name, and properties with setters."""
    cls, made = draft.fresh("Field"), draft.fresh("owner")
    draft.define(
        f"class {cls}:\n    def __init__(self, default='dd'):\n        self.default = default\n"
        "    def __set_name__(self, owner, name):\n        self.name = name\n"
        f"    def __get__(self, owner, kind=None):\n        if owner is None:\n            return 'class_' + self.name\n"
        "        return owner.__dict__.get('_' + self.name, self.default)\n"
        "    def __set__(self, owner, value):\n        owner.__dict__['_' + self.name] = value + '_' + self.name\n\n\n"
        f"class {cls}Owner:\n    topic = {cls}()\n    other = {cls}('oo')\n    def __init__(self, a):\n        self.topic = a\n"
        "    @property\n    def both(self):\n        return self.topic + self.other\n"
        "    @both.setter\n    def both(self, value):\n        self.other = value"
    )
    scope.add(f"{made} = {cls}Owner({word(draft, scope, depth)})")
    change = draft.chooser.pick(
        ["", f"{made}.both = 'bb'", f"setattr({made}, 'other', 'sa')", f"{made}.topic += '_more'"]
    )
    if change:
        scope.add(change)
    return draft.chooser.pick(
        [f"{made}.topic", f"{made}.other", f"{made}.both", f"{cls}Owner.topic", f"getattr({made}, 'topic')"]
    )


def hooked(draft: Draft, scope: Scope, depth: int) -> str:
    """Hooks at the definition of a class: `__init_subclass__`, `__class_getitem__`, class decorators, `__new__`."""
    cls, text = draft.fresh("Hook"), word(draft, scope, depth)
    kind = draft.chooser.number(0, 4)
    if kind == 0:
        draft.define(
            f"class {cls}:\n    made = {{}}\n    def __init_subclass__(cls, key=None, **kw):\n        super().__init_subclass__(**kw)\n"
            f"        {cls}.made[key or cls.__name__.lower()] = cls\n        cls.label = (key or 'none') + '_label'\n    def get(self, a):\n        return self.label + a\n\n\n"
            f"class {cls}One({cls}, key='one'):\n    pass\n\n\nclass {cls}Two({cls}One):\n    pass"
        )
        return draft.chooser.pick(
            [f"{cls}.made['one']().get({text})", f"{cls}Two().get({text})", f"'_'.join({cls}.made)", f"{cls}One.label"]
        )
    if kind == 1:
        draft.define(
            f"class {cls}:\n    def __class_getitem__(cls, item):\n        return cls.__name__ + '_' + str(item)"
        )
        return f"{cls}[{text}]"
    if kind == 2:
        draft.define(
            f"def {cls}_registered(kind):\n    {cls}_all.append(kind.__name__)\n    kind.topic = 'by_' + kind.__name__\n    return kind\n\n\n{cls}_all = []\n\n\n"
            f"@{cls}_registered\nclass {cls}:\n    pass"
        )
        return draft.chooser.pick([f"{cls}.topic", f"'_'.join({cls}_all)"])
    if kind == 3:
        draft.define(
            f"class {cls}:\n    only = None\n    def __new__(cls, *args):\n        if cls.only is None:\n            cls.only = super().__new__(cls)\n        return cls.only\n"
            "    def __init__(self, a):\n        self.a = a"
        )
        return f"({cls}('first'), {cls}({text}))[0].a"
    draft.define(
        f"class {cls}(str):\n    def __new__(cls, a):\n        made = super().__new__(cls, a + '_new')\n        made.extra = a + '_extra'\n        return made"
    )
    return draft.chooser.pick([f"{cls}({text})", f"{cls}({text}).extra", f"{cls}({text}).upper()"])


# Entities

_MAKERS: Final = (
    ("__call__(self, x='called')", "", "{o}({w})"),
    ("__getitem__(self, x)", "", "{o}[{w}]"),
    ("__setitem__(self, x, value)", "", "{o}[{w}] = 1"),
    ("__delitem__(self, x)", "", "del {o}[{w}]"),
    ("__getattr__(self, x)", "", "{o}.some_topic"),
    ("__contains__(self, x)", "return True", "{w} in {o}"),
    ("__format__(self, x)", "return 'f'", "f'{{{o}:spec}}'"),
    ("__lshift__(self, x)", "return self", "{o} << {w} << 'second'"),
    ("__iadd__(self, x)", "return self", "{o} += {w}"),
    ("__and__(self, x)", "return self", "{o} & {w}"),
    ("__str__(self, x='as_text')", "return 'text'", "'%s' % {o}"),
    ("__bool__(self, x='as_truth')", "return True", "if {o}:\n    pass"),
    ("__len__(self, x='as_length')", "return 1", "if not {o}:\n    pass"),
    ("__iter__(self, x='as_items')", "return iter('ab')", "for _ in {o}:\n    break"),
    (
        "__lt__(self, x)",
        "return False",
        "sorted([{o}, 'n0', 'n1'], key=lambda e: {o} if e is {o} else {o}) if {o} < {w} else None",
    ),
    ("__eq__(self, x)", "return True", "[{o}].index({w})"),
    ("__hash__(self, x='as_key')", "return 7", "{{{o}: 1}}"),
    ("__index__(self, x='as_number')", "return 0", "['z'][{o}]"),
    ("__enter__(self, x='entered')", "return self\ndef __exit__(self, *args):\n    return None", "with {o}:\n    pass"),
    ("__reversed__(self, x='backwards')", "return iter('ab')", "list(reversed({o}))"),
    ("__radd__(self, x)", "return x", "sum([{o}], 'start') if False else {w} + {o}"),
    ("__neg__(self, x='negated')", "return self", "-{o}"),
    ("__int__(self, x='whole')", "return 1", "int({o})"),
    ("__setattr__(self, x, value)", "", "{o}.attr_topic = 3"),
    ("__missing__(self, x)", "return x", "{o}[{w}]"),
)
"""A special method that creates something called `x`, and a statement that calls it on `{o}`."""


def made_implicitly(draft: Draft, scope: Scope, _depth: int) -> None:
    """Entities that a special method creates."""
    cls, made = draft.fresh("Maker"), draft.fresh("made")
    head, result, used = draft.chooser.pick(_MAKERS)
    call = creation(draft, scope, "x", "self.__dict__['node']")
    body = block([call, *result.split("\n")[:1]], 2)
    rest = "\n".join("    " + line for line in result.split("\n")[1:])
    base = "(dict)" if "__missing__" in head else ""
    draft.define(
        f"class {cls}{base}:\n    def __init__(self, node):\n        self.__dict__['node'] = node\n    def {head}:\n{body}\n{rest}"
    )
    scope.add(f"{made} = {cls}({scope.node})\n" + used.format(o=made, w=word(draft, scope, 0)))


def lazy_member(draft: Draft, scope: Scope, _depth: int) -> None:
    """An entity that is created when its attribute is first asked for: properties, cached properties, descriptors."""
    cls, made = draft.fresh("Lazy"), draft.fresh("lazily")
    call = creation(draft, scope, f"self.name + {draft.chooser.pick(['_l', '_m'])!r}", "self.node")
    start = "    def __init__(self, node, name):\n        self.node, self.name = node, name\n"
    how = draft.chooser.number(0, 2)
    if how == 0:
        draft.define(f"class {cls}:\n{start}    @property\n    def handle(self):\n        return {call}")
    elif how == 1:
        draft.need("import functools")
        draft.define(
            f"class {cls}:\n{start}    @functools.cached_property\n    def handle(self):\n        return {call}"
        )
    else:
        other = call.replace("self.", "owner.")
        draft.define(
            f"class {cls}Of:\n    def __get__(self, owner, kind=None):\n        return {other}\n"
            f"    def __set__(self, owner, value):\n        owner.node.create_publisher(String, owner.name + '_set', 10)\n\n\n"
            f"class {cls}:\n    handle = {cls}Of()\n{start}"
        )
    uses = [f"{made}.handle", f"getattr({made}, 'handle', None)", "pass", f"hasattr({made}, 'handle')"]
    if how == 2:
        uses.append(f"{made}.handle = 1")
    scope.add(f"{made} = {cls}({scope.node}, {word(draft, scope, 0)})\n{draft.chooser.pick(uses)}")


WAYS: Final[tuple[Way, ...]] = (special, special, special, special, descriptor, hooked)
STATEMENTS: Final[tuple[Statement, ...]] = (made_implicitly, made_implicitly, lazy_member)
