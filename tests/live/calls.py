# SPDX-License-Identifier: Apache-2.0
"""Expressions for a word that come out of functions and classes: arguments of all kinds, closures, decorators, properties, enums.

call_default(draft, scope, 1)    ->  helper1('left'), with `def helper1(a, b="x"): return a + b` in the module
"""

from __future__ import annotations

from typing import Final

from .draft import Draft, Scope, Way, block
from .values import condition, word


def _function(draft: Draft, parameters: str, names: tuple[str, ...], depth: int, head: str = "") -> str:
    """Define a function that makes a word of its parameters; its name."""
    function = draft.fresh("helper")
    inside = Scope(names=list(names))
    result = word(draft, inside, depth)
    draft.define(f"{head}def {function}({parameters}):\n{block([*inside.lines, f'return {result}'])}")
    return function


def call(draft: Draft, scope: Scope, depth: int) -> str:
    one, two = word(draft, scope, depth), word(draft, scope, depth)
    kind = draft.chooser.number(0, 8)
    if kind == 0:
        return f"{_function(draft, 'a', ('a',), depth)}({one})"
    if kind == 1:
        return f"{_function(draft, 'a, b=' + repr('dflt'), ('a', 'b'), depth)}({one})"
    if kind == 2:
        return f"{_function(draft, 'a, b=' + repr('dflt'), ('a', 'b'), depth)}(b={one}, a={two})"
    if kind == 3:
        return f"{_function(draft, '*args', ('args[0]', 'args[-1]'), depth)}({one}, *[{two}])"
    if kind == 4:
        named = _function(draft, "**kw", ("kw['x']", "kw.get('y', 'z')"), depth)
        return f"{named}(**{{'x': {one}}})"
    if kind == 5:
        return f"{_function(draft, 'a, /, *, k', ('a', 'k'), depth)}({one}, k={two})"
    if kind == 6:
        every = _function(draft, "a, *args, k='kd', **kw", ("a", "k", "len(args) * 'w' + a"), depth)
        return f"{every}({one}, {two}, 'third')"
    if kind == 7:
        draft.need("from functools import partial")
        return f"partial({_function(draft, 'a, b', ('a', 'b'), depth)}, {one})({two})"
    return f"(lambda a, b='lb': {draft.chooser.pick(['a + b', 'b', 'f_(a) if a else b'.replace('f_', 'str')])})({one})"


def closure(draft: Draft, scope: Scope, depth: int) -> str:
    function = draft.fresh("maker")
    outer = Scope(names=["a"])
    captured = word(draft, outer, depth)
    kind = draft.chooser.number(0, 3)
    change = "    nonlocal kept\n    kept = kept + '_n'\n" if kind == 1 else ""
    inner = f"def inner(b='ib'):\n{change}    return kept + '_' + b"
    result = "inner" if kind != 2 else "[inner for _ in range(2)][1]"
    if kind == 3:
        inner, result = "table = {k: (lambda b='lb', k=k: k + kept + b) for k in ('p', 'q')}", "table['q']"
    draft.define(
        f"def {function}(a):\n{block([*outer.lines, f'kept = {captured}', *inner.splitlines(), f'return {result}'])}"
    )
    name = draft.fresh("fn")
    scope.add(f"{name} = {function}({word(draft, scope, depth)})")
    if kind == 1:
        scope.add(f"{name}()")
    return f"{name}()"


def early(draft: Draft, scope: Scope, depth: int) -> str:
    function = draft.fresh("early")
    inside = Scope(names=["a"])
    test = condition(draft, inside, depth)
    first, second = inside.inner(), inside.inner()
    one, two = word(draft, first, depth), word(draft, second, depth)
    lines = [
        *inside.lines,
        f"if {test}:",
        *block([*first.lines, f"return {one}"]).splitlines(),
        *second.lines,
        f"return {two}",
    ]
    draft.define(f"def {function}(a):\n{block(lines)}")
    return f"{function}({word(draft, scope, depth)})"


def recursion(draft: Draft, scope: Scope, depth: int) -> str:
    function = draft.fresh("rec")
    kind = draft.chooser.number(0, 1)
    text = word(draft, scope, depth)
    if kind == 0:
        draft.define(
            f"def {function}(a, n):\n    if n == 0:\n        return a\n    return {function}(a + str(n), n - 1)"
        )
        return f"{function}({text}, {draft.chooser.number(0, 3)})"
    draft.define(
        f"def {function}(tree):\n    if isinstance(tree, str):\n        return tree\n"
        f"    return '_'.join({function}(t) for t in tree)"
    )
    return f"{function}([{text}, ['in', ['deep']]])"


def generator(draft: Draft, scope: Scope, depth: int) -> str:
    function = draft.fresh("gen")
    inside = Scope(names=["a"])
    one, two = word(draft, inside, depth), word(draft, inside, depth)
    draft.define(
        f"def {function}(a):\n"
        f"{block([*inside.lines, f'yield {one}', f'yield {two}', 'yield from (a, a + ' + repr('y') + ')'])}"
    )
    text = word(draft, scope, depth)
    return draft.chooser.pick(
        [
            f"next({function}({text}))",
            f"'_'.join({function}({text}))",
            f"list({function}({text}))[1]",
            f"[g for g in {function}({text})][-1]",
            f"sorted({function}({text}))[0]",
            f"max({function}({text}), key=len)",
            f"dict(enumerate({function}({text})))[2]",
        ]
    )


def decorated(draft: Draft, scope: Scope, depth: int) -> str:
    decorator = draft.fresh("deco")
    kind = draft.chooser.number(0, 3)
    if kind == 0:
        draft.define(
            f"def {decorator}(f):\n    def wrapper(*args, **kw):\n"
            "        return f(*args, **kw) + '_d'\n    return wrapper"
        )
        head = f"@{decorator}\n"
    elif kind == 1:
        draft.need("import functools")
        draft.define(
            f"def {decorator}(suffix):\n    def outer(f):\n        @functools.wraps(f)\n"
            "        def wrapper(*args):\n            return suffix + '_' + f(*args)\n"
            "        return wrapper\n    return outer"
        )
        head = f"@{decorator}({word(draft, Scope(), 0)})\n"
    elif kind == 2:
        draft.need("import functools")
        head = draft.chooser.pick(
            ["@functools.lru_cache(maxsize=None)\n", "@functools.cache\n", "@functools.lru_cache\n"]
        )
    else:
        draft.define(
            f"class {decorator}:\n    def __init__(self, f):\n        self.f = f\n"
            "        self.count = 0\n    def __call__(self, a):\n        self.count += 1\n"
            "        return self.f(a) + str(self.count)"
        )
        head = f"@{decorator}\n"
    function = _function(draft, "a", ("a",), depth, head)
    return f"{function}({word(draft, scope, depth)})"


def context(draft: Draft, scope: Scope, depth: int) -> str:
    name, text = draft.fresh("cm"), word(draft, scope, depth)
    if draft.chooser.chance(50):
        draft.need("from contextlib import contextmanager")
        draft.define(f"@contextmanager\ndef {name}(a):\n    yield a + '_cm'")
    else:
        draft.define(
            f"class {name}:\n    def __init__(self, a):\n        self.a = a\n"
            "    def __enter__(self):\n        return self.a + '_in'\n"
            "    def __exit__(self, *args):\n        return False"
        )
    scope.add(f"with {name}({text}) as {name}_value:\n    {name}_kept = {name}_value + '_w'")
    return draft.chooser.pick([f"{name}_kept", f"{name}_value"])


# Classes of the program's own


def class_attribute(draft: Draft, scope: Scope, depth: int) -> str:
    cls, top = draft.fresh("Config"), Scope()
    value = word(draft, top, depth)
    draft.module += top.lines
    kind = draft.chooser.number(0, 6)
    if kind == 0:
        draft.define(f"class {cls}:\n    topic = {value}\n    other = topic + '_o'")
        return draft.chooser.pick(
            [
                f"{cls}.topic",
                f"{cls}().other",
                f"getattr({cls}, 'topic')",
                f"vars({cls})['topic']",
                f"{cls}.__dict__['other']",
            ]
        )
    if kind == 1:
        draft.define(f"class {cls}Base:\n    topic = {value}\n\n\nclass {cls}({cls}Base):\n    pass")
        return f"{cls}.topic"
    if kind == 2:
        draft.define(f"class {cls}:\n    topic = 'old'\n\n\n{cls}.topic = {value}")
        return f"{cls}().topic"
    if kind == 3:
        draft.define(
            f"class {cls}:\n    topic = {value}\n    @classmethod\n    def get(cls, a='ca'):\n"
            "        return cls.topic + a\n    @staticmethod\n    def plain(a):\n"
            "        return a + '_s'"
        )
        return draft.chooser.pick(
            [f"{cls}.get()", f"{cls}().get({word(draft, scope, depth)})", f"{cls}.plain({word(draft, scope, depth)})"]
        )
    if kind == 4:
        draft.define(
            f"class {cls}:\n    count = 0\n    names = []\n    def __init__(self, a):\n"
            f"        {cls}.count += 1\n        self.names.append(a)\n"
            f"        self.a = a + str({cls}.count)\n\n\n{cls}({value})"
        )
        return f"{cls}({word(draft, scope, depth)}).a"
    if kind == 5:
        draft.define(f"class {cls}:\n    class Inner:\n        topic = {value}\n    table = {{'a': Inner.topic}}")
        return draft.chooser.pick([f"{cls}.Inner.topic", f"{cls}.table['a']"])
    draft.define(
        f"class {cls}:\n    topic = {value}\n    def __init__(self):\n"
        f"        if {condition(draft, Scope(), 0)}:\n            self.topic = 'own'"
    )
    return f"{cls}().topic"


def instance(draft: Draft, scope: Scope, depth: int) -> str:
    cls, inside = draft.fresh("Thing"), Scope(names=["a", "b"])
    value = word(draft, inside, depth)
    start = block([*inside.lines, f"self.a = {value}", "self.b = b"], 2)
    kind = draft.chooser.number(0, 7)
    one = word(draft, scope, depth)
    init = f"class {cls}:\n    def __init__(self, a, b='tb'):\n{start}\n"
    if kind == 0:
        draft.define(init)
        return draft.chooser.pick([f"{cls}({one}).a", f"{cls}(a={one}, b='kb').b", f"getattr({cls}({one}), 'a')"])
    if kind == 1:
        draft.define(init + "    @property\n    def topic(self):\n        return self.a + '_p'")
        return f"{cls}({one}).topic"
    if kind == 2:
        draft.define(
            init
            + (
                "    def get(self, c):\n        self.a += c\n        return self\n"
                "    def __str__(self):\n        return self.a + '_str'"
            )
        )
        return draft.chooser.pick(
            [f"str({cls}({one}))", f"{cls}({one}).get('g').get('h').a", f'f"{{{cls}({one})}}"', f"'%s' % {cls}({one})"]
        )
    if kind == 3:
        draft.define(
            init
            + (
                f"\n\nclass {cls}Sub({cls}):\n    def __init__(self, *args, **kw):\n"
                "        super().__init__(*args, **kw)\n        self.a = 'sub_' + self.a"
            )
        )
        return f"{cls}Sub({one}).a"
    if kind == 4:
        draft.define(
            init
            + (
                "    def __getitem__(self, key):\n        return self.a + str(key)\n"
                "    def __call__(self, c='cc'):\n        return self.a + c\n"
                "    def __getattr__(self, name):\n        return 'dyn_' + name\n"
                "    def __len__(self):\n        return 2\n    def __add__(self, other):\n"
                "        return self.a + other\n    def __iter__(self):\n"
                "        return iter([self.a, self.b])\n    def __contains__(self, x):\n"
                "        return x == self.a\n    def __eq__(self, other):\n        return True\n"
                "    def __hash__(self):\n        return 1"
            )
        )
        return draft.chooser.pick(
            [
                f"{cls}({one})[1]",
                f"{cls}({one})()",
                f"{cls}({one}).unknown_one",
                f"({cls}({one}) + '_add')",
                f"('l' + str(len({cls}({one}))))",
                f"'_'.join({cls}({one}))",
                f"('yes' if 'zz' in {cls}({one}) else 'no')",
                f"('eq' if {cls}({one}) == 3 else 'ne')",
                f"list({cls}({one}))[1]",
            ]
        )
    if kind == 5:
        draft.define(
            init
            + (
                "    @property\n    def topic(self):\n        return self._t\n    @topic.setter\n"
                "    def topic(self, value):\n        self._t = value + '_set'"
            )
        )
        name = draft.fresh("thing")
        scope.add(f"{name} = {cls}({one})\n{name}.topic = {word(draft, scope, depth)}")
        return f"{name}.topic"
    if kind == 6:
        draft.define(
            init
            + (
                "    made = {}\n    @classmethod\n    def of(cls, a):\n        if a not in cls.made:\n"
                "            cls.made[a] = cls(a)\n        return cls.made[a]"
            )
        )
        return f"{cls}.of({one}).a"
    draft.define(
        init
        + (
            "    def __new__(cls, *args, **kw):\n        self = super().__new__(cls)\n"
            "        self.pre = 'pre'\n        return self"
        )
    )
    return f"{cls}({one}).pre"


def record(draft: Draft, scope: Scope, depth: int) -> str:
    cls, one = draft.fresh("Rec"), word(draft, scope, depth)
    kind = draft.chooser.number(0, 4)
    if kind == 0:
        draft.need("from dataclasses import dataclass, field, replace, asdict, astuple, fields")
        draft.define(
            f"@dataclass\nclass {cls}:\n    a: str\n    b: str = 'db'\n"
            "    c: list = field(default_factory=lambda: ['fc'])\n    def __post_init__(self):\n"
            "        self.d = self.a + self.b"
        )
        return draft.chooser.pick(
            [
                f"{cls}({one}).a",
                f"{cls}({one}).b",
                f"{cls}(a={one}, b='kb').d",
                f"{cls}({one}).c[0]",
                f"replace({cls}({one}), b='rb').b",
                f"asdict({cls}({one}))['a']",
                f"('_'.join(f.name for f in fields({cls})))",
                f"astuple({cls}({one}))[1]",
            ]
        )
    if kind == 1:
        draft.need("from enum import Enum")
        top = Scope()
        value = word(draft, top, depth)
        draft.module += top.lines
        draft.define(
            f"class {cls}(Enum):\n    ONE = {value} + '_e'\n    TWO = 'two'\n    @property\n"
            "    def topic(self):\n        return self.value + '_t'"
        )
        return draft.chooser.pick(
            [
                f"{cls}.ONE.value",
                f"{cls}.TWO.name",
                f"{cls}['TWO'].value",
                f"{cls}('two').name",
                f"{cls}.ONE.topic",
                f"[e.value for e in {cls}][0]",
                f"'_'.join(e.name for e in {cls})",
                f"{cls}.__members__['TWO'].value",
            ]
        )
    if kind == 2:
        draft.need("from enum import IntEnum")
        draft.define(f"class {cls}(IntEnum):\n    ONE = 1\n    TWO = 2")
        return draft.chooser.pick(
            [f'f"n{{{cls}.TWO}}"', f"('n' + str({cls}.ONE + 4))", f"{cls}(2).name", f"['p', 'q', 'r'][{cls}.TWO]"]
        )
    if kind == 3:
        draft.need("from typing import NamedTuple")
        draft.define(
            f"class {cls}(NamedTuple):\n    a: str\n    b: str = 'nb'\n    @property\n"
            "    def topic(self):\n        return self.a + '_nt'"
        )
        return draft.chooser.pick(
            [f"{cls}({one}).b", f"{cls}({one}).topic", f"{cls}({one}, 'x')[1]", f"(lambda x, y: x + y)(*{cls}({one}))"]
        )
    draft.need("from types import SimpleNamespace")
    return f"SimpleNamespace(a={one}).a"


def library(draft: Draft, scope: Scope, depth: int) -> str:
    draft.need("import json, os, re, itertools, functools, operator, string, collections, copy, pathlib, textwrap")
    one, two = word(draft, scope, depth), word(draft, scope, depth)
    return draft.chooser.pick(
        [
            f"json.loads(json.dumps({{'a': {one}}}))['a']",
            f"os.path.join({one}, {two})",
            f"os.path.basename('dir/' + {one})",
            f"os.path.splitext({one} + '.ext')[0]",
            f"re.sub('[aeiou]', 'v', {one})",
            f"re.sub(r'[^a-z0-9/_]', '', {one}) + 'r'",
            "re.match('[a-z]+', 'abc1').group(0)",
            f"list(itertools.chain([{one}], [{two}]))[1]",
            f"'_'.join(a + b for a, b in itertools.product([{one}], ['p', 'q']))",
            f"functools.reduce(lambda a, b: a + b, [{one}, {two}])",
            f"operator.itemgetter('a')({{'a': {one}}})",
            f"operator.add({one}, {two})",
            f"string.Template('$a').substitute(a={one})",
            f"collections.Counter([{one}]).most_common(1)[0][0]",
            f"copy.deepcopy({{'a': [{one}]}})['a'][0]",
            f"copy.copy([{one}])[0]",
            f"pathlib.PurePosixPath('/x', {one}).name",
            f"str(pathlib.PurePosixPath({one}) / 'y')",
            f"textwrap.dedent({one})",
            f"collections.OrderedDict(a={one})['a']",
            f"collections.ChainMap({{'a': {one}}}, {{}})['a']",
            f"list(itertools.islice([{one}, {two}], 1, 2))[0]",
            f"list(zip(*[({one}, 'p'), ({two}, 'q')]))[0][1]",
            f"operator.attrgetter('__name__')(str) + {one}",
            f"'_'.join(re.findall('[a-z]+', {one}))",
            f"re.split('[_/]', {one})[0] + 's'",
            f"next(itertools.cycle([{one}]))",
            f"list(itertools.accumulate(['p', {one}]))[-1]",
        ]
    )


CALL_WAYS: Final[tuple[Way, ...]] = (
    *(call, call, call, closure, early, early, recursion, generator, decorated, context),
    *(class_attribute, class_attribute, instance, instance, instance, record, record, library),
)
