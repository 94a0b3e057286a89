# SPDX-License-Identifier: Apache-2.0
"""Expressions for a part of a name, as real code writes them: about fifty ways to say a word.

    word(draft, scope, 2)    ->  f"{TOPIC1}_{helper1('left')}", with TOPIC1 and helper1 defined in the module

Every expression is a string like `a`, `left_2` or `a/b`: what a name may hold anywhere but at its beginning or end.
"""

from __future__ import annotations

from typing import Final

from .draft import Draft, Scope, Way, block

WORDS: Final = ("left", "right", "scan", "odom", "cmd", "arm", "base", "front", "rear", "map")


def word(draft: Draft, scope: Scope, depth: int) -> str:
    """An expression for a string."""
    if scope.names and draft.chooser.chance(40):
        return draft.chooser.pick(scope.names)
    if depth <= 0:
        return _literal(draft)
    way = draft.chooser.pick(draft.ways if scope.node is None else (*draft.ways, *draft.node_ways))
    draft.used.add(way.__name__)
    return way(draft, scope, depth - 1)


def _literal(draft: Draft) -> str:
    return repr(draft.chooser.pick(WORDS))


def words(draft: Draft, scope: Scope, depth: int, low: int = 1, high: int = 3) -> list[str]:
    """Several expressions."""
    return [word(draft, scope, depth) for _ in range(draft.chooser.number(low, high))]


# Text


def literal(draft: Draft, _scope: Scope, _depth: int) -> str:
    return _literal(draft)


def fstring(draft: Draft, scope: Scope, depth: int) -> str:
    left, right = draft.fresh("f"), word(draft, scope, depth)
    scope.add(f"{left} = {word(draft, scope, depth)}")
    scope.add(f"{left}b = {right}")
    return draft.chooser.pick(
        [
            f'f"{{{left}}}_{{{left}b}}"',
            f'f"{{{left}}}/{{{left}b}}"',
            f'f"{{{left}}}{{{draft.chooser.number(0, 9)}}}"',
            f'f"{{{left}!s:s}}_{{{left}b:>4}}".replace(" ", "x")',
        ]
    )


def concatenation(draft: Draft, scope: Scope, depth: int) -> str:
    middle = draft.chooser.pick(["_", "/", "_x_"])
    return f"({word(draft, scope, depth)} + {middle!r} + {word(draft, scope, depth)})"


def format_method(draft: Draft, scope: Scope, depth: int) -> str:
    one, two = word(draft, scope, depth), word(draft, scope, depth)
    return draft.chooser.pick(
        [
            f'"{{}}_{{}}".format({one}, {two})',
            f'"{{1}}/{{0}}".format({one}, {two})',
            f'"{{a}}{{b}}".format(a={one}, b={two})',
            f'"{{0[0]}}_{{0[1]}}".format([{one}, {two}])',
        ]
    )


def percent(draft: Draft, scope: Scope, depth: int) -> str:
    one = word(draft, scope, depth)
    return draft.chooser.pick(
        [
            f'("%s_%d" % ({one}, {draft.chooser.number(0, 20)}))',
            f'("%s" % {one})',
            f'("%(a)s_%(b)02d" % {{"a": {one}, "b": 3}})',
        ]
    )


def join(draft: Draft, scope: Scope, depth: int) -> str:
    parts = ", ".join(words(draft, scope, depth))
    return draft.chooser.pick(
        [
            f'"_".join([{parts}])',
            f'"/".join(w for w in ({parts},))',
            f'"_".join(map(str, ({parts}, 1)))',
            f'"_".join(sorted({{{parts}}}))',
            f'"_".join(reversed([{parts}]))',
            f'"_".join(dict.fromkeys([{parts}]))',
        ]
    )


def method(draft: Draft, scope: Scope, depth: int) -> str:
    text = word(draft, scope, depth)
    return text + draft.chooser.pick(
        [
            ".upper()",
            ".lower()",
            ".strip()",
            ".title()",
            ".replace('a', 'o')",
            ".replace('_', '')",
            ".split('_')[0]",
            ".split('/')[-1]",
            ".rsplit('_', 1)[0]",
            ".partition('_')[0]",
            ".lstrip('_')",
            ".removeprefix('left_')",
            ".capitalize()",
            ".zfill(6).replace('0', 'z')",
            ".center(8, 'x')",
            "[:]",
            "[:40]",
            "[-30:]",
            ".swapcase()",
            ".removesuffix('x')",
            ".ljust(6, 'y')",
            ".casefold()",
            ".encode().decode()",
            ".expandtabs()",
            ".translate(str.maketrans('a', 'e'))",
        ]
    )


def number(draft: Draft, scope: Scope, depth: int) -> str:
    text = word(draft, scope, depth)
    return draft.chooser.pick(
        [
            f"('n' + str(len({text})))",
            f'f"n{{2 * {draft.chooser.number(1, 5)} + 1}}"',
            f'"n%d" % (len({text}) // 2)',
            f"('n' + str(sum(range({draft.chooser.number(1, 5)}))))",
            f"('n' + str(max(3, len({text}))))",
            f"('h' + hex(len({text}))[2:])",
            f'"k{{:02d}}".format({draft.chooser.number(0, 30)})',
            f"chr(97 + len({text}) % 26)",
            f"('n' + str(divmod(len({text}), 3)[0]))",
            "('n' + str(round(2.6)) + str(int('7')))",
            f"('n' + str(abs(-len({text}))))",
        ]
    )


# Names


def constant(draft: Draft, _scope: Scope, depth: int) -> str:
    name = draft.fresh("TOPIC")
    top = Scope()
    value = word(draft, top, depth)
    draft.module += top.lines
    draft.define(f"{name} = {value}")
    return name


def local(draft: Draft, scope: Scope, depth: int) -> str:
    name = draft.fresh("local")
    scope.add(f"{name} = {word(draft, scope, depth)}")
    change = draft.chooser.number(0, 3)
    if change == 1:
        scope.add(f"{name} += '_' + {word(draft, scope, depth)}")
    elif change == 2:
        scope.add(f"{name}, {name}b = {word(draft, scope, depth)}, {name}")
        return f"({name} + {name}b)"
    elif change == 3:
        scope.add(f"{name}b, *{name}c = [{name}, {word(draft, scope, depth)}, 'z']")
        return f"({name}b + {name}c[0] + {name}c[-1])"
    return name


def walrus(draft: Draft, scope: Scope, depth: int) -> str:
    name = draft.fresh("w")
    scope.add(f"{name}b = ({name} := {word(draft, scope, depth)}) + '_' + {name}")
    return f"{name}b"


def imported(draft: Draft, _scope: Scope, depth: int) -> str:
    module, name = draft.chooser.pick(["names", "config", "pack.topics"]), draft.fresh("NAME")
    there = Draft(draft.chooser, draft.known, ways=draft.ways, numbers=draft.numbers)
    top = Scope()
    value = word(there, top, min(depth, 1)) if draft.chooser.chance(50) else _literal(draft)
    lines = draft.files.setdefault(module.replace(".", "/") + ".py", [])
    if module.startswith("pack"):
        draft.files.setdefault("pack/__init__.py", [])
    lines += [*sorted(there.imports), *there.module, *top.lines, f"{name} = {value}"]
    for file, more in there.files.items():
        draft.files.setdefault(file, []).extend(m for m in more if m not in draft.files[file])
    how = draft.chooser.number(0, 3)
    if how == 0:
        draft.need(f"from {module} import {name}")
        return name
    if how == 1:
        alias = draft.fresh("alias")
        draft.need(f"from {module} import {name} as {alias}")
        return alias
    if how == 2:
        draft.need(f"import {module}")
        return f"{module}.{name}"
    alias = draft.fresh("mod")
    draft.need(f"import {module} as {alias}")
    return f"getattr({alias}, {name!r})" if draft.chooser.chance(30) else f"{alias}.{name}"


def global_variable(draft: Draft, scope: Scope, depth: int) -> str:
    name, function = draft.fresh("state"), draft.fresh("set_state")
    draft.define(f"{name} = {_literal(draft)}")
    inside = Scope()
    value = word(draft, inside, depth)
    draft.define(f"def {function}():\n    global {name}\n{block([*inside.lines, f'{name} = {value}'])}")
    if scope.node is not None or draft.chooser.chance(50):
        scope.add(f"{function}()")
    return name


def environment(draft: Draft, scope: Scope, depth: int) -> str:
    draft.need("import os")
    return draft.chooser.pick(
        [
            f"os.environ.get('NEVER_SET_BY_ANYONE', {word(draft, scope, depth)})",
            f"os.getenv('NEVER_SET_BY_ANYONE', {word(draft, scope, depth)})",
            f"(os.environ.get('NEVER_SET_BY_ANYONE') or {word(draft, scope, depth)})",
        ]
    )


# Decisions


def condition(draft: Draft, scope: Scope, depth: int) -> str:
    """An expression whose truth the program alone decides, unless unknown ones are allowed."""
    if not draft.known and draft.chooser.chance(50):
        draft.need("import sys, os, time, random")
        return draft.chooser.pick(
            [
                "len(sys.argv) > 3",
                "'NEVER_SET_BY_ANYONE' in os.environ",
                "time.time() > 5.0",
                "random.random() < 0.5",
                "sys.argv[0] == 'x'",
            ]
        )
    text = word(draft, scope, depth)
    return draft.chooser.pick(
        [
            "True",
            "False",
            "not 0",
            "__debug__",
            "isinstance('x', str)",
            "3 > 2 > 1",
            "bool([])",
            f"{text} == 'left'",
            f"'a' in {text}",
            f"{text}.startswith('l')",
            f"len({text}) > 4",
            f"{text} in ('left', 'right')",
            f"({text}, None)[1] is None",
            f"any(c == 'e' for c in {text})",
            f"all([{text}])",
            f"not {text}",
            f"{text} < 'm'",
            f"({text} and True)",
            f"{text} != {_literal(draft)} or False",
            f"callable({text})",
            f"hash(1) == 1 and {text}.isalpha()",
        ]
    )


def conditional(draft: Draft, scope: Scope, depth: int) -> str:
    one, two = word(draft, scope, depth), word(draft, scope, depth)
    return f"({one} if {condition(draft, scope, depth)} else {two})"


def branch(draft: Draft, scope: Scope, depth: int) -> str:
    name = draft.fresh("b")
    test = condition(draft, scope, depth)
    one, two = scope.inner(), scope.inner()
    one.add(f"{name} = {word(draft, one, depth)}")
    two.add(f"{name} = {word(draft, two, depth)}")
    if draft.chooser.chance(30):
        scope.add(f"{name} = {_literal(draft)}")
        scope.add(f"if {test}:\n{block(one.lines)}")
    elif draft.chooser.chance(30):
        scope.add(
            f"if {test}:\n{block(one.lines)}\nelif {condition(draft, scope, 0)}:\n"
            f"    {name} = 'elif'\nelse:\n{block(two.lines)}"
        )
    else:
        scope.add(f"if {test}:\n{block(one.lines)}\nelse:\n{block(two.lines)}")
    return name


def match(draft: Draft, scope: Scope, depth: int) -> str:
    name = draft.fresh("m")
    subject = word(draft, scope, depth)
    case = draft.chooser.pick(
        [
            "'left' | 'right' as side:\n        {n} = side + '_s'",
            "str(x) if len(x) > 3:\n        {n} = x + '_long'",
            "'scan':\n        {n} = 'matched'",
        ]
    )
    scope.add(f"match {subject}:\n    case {case.format(n=name)}\n    case other:\n        {name} = other + '_other'")
    return name


def boolean(draft: Draft, scope: Scope, depth: int) -> str:
    text = word(draft, scope, depth)
    return draft.chooser.pick(
        [f"(None or {text})", f"('' or {text})", f"({text} and {word(draft, scope, depth)})", f"({text} or 'never')"]
    )


def attempt(draft: Draft, scope: Scope, depth: int) -> str:
    name = draft.fresh("t")
    text, other = word(draft, scope, depth), word(draft, scope, depth)
    risky = draft.chooser.pick(
        [
            f"{name} = {{'left': 'l'}}[{text}]",
            f"{name} = str(int({text}))",
            f"{name} = [{text}][0]",
            f"{name} = {text}\n    raise ValueError({text})",
            f"{name} = {text}.missing",
        ]
    )
    error = draft.chooser.pick(["Exception", "(KeyError, ValueError, AttributeError)"])
    tail = draft.chooser.pick(["", f"\nfinally:\n    {name}f = 'f'", f"\nelse:\n    {name} = {name} + '_ok'"])
    scope.add(f"try:\n    {risky}\nexcept {error}:\n    {name} = {other}{tail}")
    return name


# Collections


def item(draft: Draft, scope: Scope, depth: int) -> str:
    parts = words(draft, scope, depth, 2, 3)
    listed = ", ".join(parts)
    return draft.chooser.pick(
        [
            f"[{listed}][{draft.chooser.number(-2, 1)}]",
            f"({listed},)[0]",
            f"{{'a': {parts[0]}, 'b': {parts[1]}}}['b']",
            f"{{'a': {parts[0]}}}.get('c', {parts[1]})",
            f"list({{'a': {parts[0]}, 'b': {parts[1]}}}.values())[-1]",
            f"sorted([{listed}])[0]",
            f"max({listed})",
            f"min([{listed}], key=len)",
            f"dict(a={parts[0]}, b={parts[1]})['a']",
            f"dict(zip(('a', 'b'), ({listed},)))['b']",
            f"[w for w in [{listed}] if w][0]",
            f"next(iter([{listed}]))",
            f"{{k: v for k, v in [('a', {parts[0]})]}}['a']",
            f"({{'a': {parts[0]}}} | {{'b': {parts[1]}}})['b']",
            f"[*({listed},), 'x'][1]",
            f"{{**{{'a': {parts[0]}}}, 'b': {parts[1]}}}['a']",
            f"list(filter(None, ['', {listed}]))[0]",
            f"list(enumerate([{listed}]))[1][1]",
            f"{{'x': {{'y': [{listed}]}}}}['x']['y'][0]",
            f"([{listed}] * 2)[2]",
            f"([{parts[0]}] + [{parts[1]}])[1]",
            f"tuple(reversed([{listed}]))[0]",
            f"[{listed}].pop()",
            f"{{'a': {parts[0]}}}.pop('a')",
            f"{{'a': {parts[0]}}}.setdefault('b', {parts[1]})",
            f"[[{listed}][i] for i in range(2)][1]",
            f"list(map(lambda w: w + '_m', [{listed}]))[0]",
        ]
    )


def collected(draft: Draft, scope: Scope, depth: int) -> str:
    name = draft.fresh("col")
    parts = words(draft, scope, depth, 2, 3)
    kind = draft.chooser.number(0, 7)
    if kind == 0:
        scope.add(f"{name} = []\nfor x in ({', '.join(parts)},):\n    {name}.append(x + '_c')")
        return f"{name}[{draft.chooser.pick(['0', '-1', '1'])}]"
    if kind == 1:
        scope.add(f"{name} = {{}}\nfor i, x in enumerate([{', '.join(parts)}]):\n    {name}[i] = x")
        return f"{name}[{draft.chooser.number(0, 1)}]"
    if kind == 2:
        draft.need("from collections import defaultdict")
        scope.add(f"{name} = defaultdict(list)\n{name}['a'].append({parts[0]})\n{name}['a'].append({parts[1]})")
        return f"{name}['a'][1]"
    if kind == 3:
        scope.add(f"{name} = [{', '.join(parts)}]\n{name}.insert(0, 'first')\n{name}.extend(['last'])\ndel {name}[1]")
        return f"{name}[{draft.chooser.pick(['0', '-1', '1'])}]"
    if kind == 4:
        draft.need("from collections import namedtuple")
        scope.add(f"{name} = namedtuple('{name}', 'one two')({parts[0]}, {parts[1]})")
        return draft.chooser.pick(
            [f"{name}.two", f"{name}[0]", f"{name}._replace(one='q').one", f"{name}._asdict()['two']"]
        )
    if kind == 5:
        scope.add(f"{name} = {{'a': {parts[0]}}}\n{name}.update(b={parts[1]})\n{name}.update({{'a': 'up'}})")
        return f"{name}[{draft.chooser.pick(['a', 'b'])!r}]"
    if kind == 6:
        draft.need("from collections import deque")
        scope.add(f"{name} = deque([{', '.join(parts)}])\n{name}.appendleft('first')\n{name}.rotate(1)")
        return draft.chooser.pick([f"{name}[0]", f"{name}.pop()", f"{name}.popleft()"])
    scope.add(f"{name} = [{', '.join(parts)}]\n{name}b = {name}\n{name}b[0] = {parts[0]} + '_aliased'")
    return f"{name}[0]"


def loop(draft: Draft, scope: Scope, depth: int) -> str:
    name = draft.fresh("acc")
    kind = draft.chooser.number(0, 5)
    text = word(draft, scope, depth)
    if kind == 0:
        scope.add(f"{name} = {text}\nfor i in range({draft.chooser.number(0, 4)}):\n    {name} += str(i)")
    elif kind == 1:
        scope.add(f"{name} = {text}\nwhile len({name}) < 12:\n    {name} = {name} + 'p'")
    elif kind == 2:
        scope.add(
            f"{name} = 'none'\nfor x in ({text}, 'b', 'c'):\n    if x == 'b':\n        break\n"
            f"    {name} = x\nelse:\n    {name} = 'else'"
        )
    elif kind == 3:
        scope.add(f"{name} = ''\nfor x, y in zip([{text}, 'b'], 'pq'):\n    {name} += x + y")
    elif kind == 4:
        scope.add(
            f"{name} = {text}\ncount = 0\nwhile True:\n    count += 1\n    if count > 3:\n"
            f"        break\n    if count == 2:\n        continue\n    {name} += str(count)"
        )
    else:
        scope.add(
            f"{name} = {text}\nfor key, value in {{'a': 'one', 'b': 'two'}}.items():\n"
            f"    if key in {name}:\n        {name} = {name} + value"
        )
    return name


WAYS: Final[tuple[Way, ...]] = (
    *(
        literal,
        literal,
        fstring,
        fstring,
        concatenation,
        concatenation,
        format_method,
        percent,
        join,
        method,
        method,
        number,
    ),
    *(constant, constant, local, walrus, imported, global_variable, environment),
    *(conditional, branch, match, boolean, attempt, item, item, collected, collected, loop, loop),
)
