# SPDX-License-Identifier: Apache-2.0
"""Which exceptions get out of a `with`? Context managers that swallow by kind or flag, of classes, generators, stacks.

with Guard1("left") as value1:
    raise KeyError("x")
done1 = value1                         reached where Guard1 swallows a KeyError
"""

from __future__ import annotations

from typing import Final

from ..draft import Draft, Scope, Statement, Way, block
from ..entities import create
from ..values import condition, word

_FAILURES: Final = ("KeyError", "ValueError", "IndexError", "RuntimeError")


def manager(draft: Draft) -> str:
    """Define something for `with` that is called with one word and gives one; its name."""
    return _of_generator(draft) if draft.chooser.chance(40) else _of_class(draft)


def _of_class(draft: Draft) -> str:
    name = draft.fresh("Guard")
    swallows = draft.chooser.pick(
        [
            *("False", "True", "None", "self.flag", "not self.flag", "kind is KeyError"),
            *("kind is not None and issubclass(kind, LookupError)", "isinstance(error, (KeyError, ValueError))"),
            *("error is not None and error.args[0] == self.a", "self.seen == 'KeyError'"),
        ]
    )
    sees = draft.chooser.pick(
        ["self.seen = kind.__name__", "self.seen = str(error.args[0])", "self.flag = not self.flag"]
    )
    base = draft.chooser.pick(["", "", "(contextlib.ContextDecorator)", "(contextlib.AbstractContextManager)"])
    draft.need("import contextlib")
    draft.define(
        f"class {name}{base}:\n    seen = 'nothing'\n    flag = {draft.chooser.pick(['True', 'False'])}\n"
        "    def __init__(self, a):\n        self.a = a\n    def __enter__(self):\n        return self.a + '_in'\n"
        f"    def __exit__(self, kind, error, trace):\n        if kind is not None:\n            {sees}\n"
        f"        return {swallows}"
    )
    return name


def _of_generator(draft: Draft) -> str:
    name = draft.fresh("guarded")
    draft.need("import contextlib")
    body = draft.chooser.pick(
        [
            "yield a + '_g'",
            "try:\n    yield a + '_g'\nexcept KeyError:\n    a = a + '_key'",
            "try:\n    yield a + '_g'\nfinally:\n    a = 'closed'",
            "try:\n    yield a\nexcept LookupError as error:\n    raise ValueError(a) from error",
            "try:\n    yield a\nexcept Exception as error:\n    if isinstance(error, ValueError):\n        raise",
            "with contextlib.suppress(KeyError):\n    yield a + '_s'",
        ]
    )
    draft.define(f"@contextlib.contextmanager\ndef {name}(a):\n{block(body.splitlines())}")
    return name


def swallowed(draft: Draft, scope: Scope, depth: int) -> str:
    """A block that fails or not, under one manager, and who gets the exception."""
    name, guard = draft.fresh("held"), manager(draft)
    fails = f"raise {draft.chooser.pick(_FAILURES)}({word(draft, scope, 0)})"
    if draft.chooser.chance(50):
        fails = f"if {condition(draft, scope, 0)}:\n    {fails}"
    scope.add(
        f"{name} = 'before'\ntry:\n    with {guard}({word(draft, scope, depth)}) as value:\n        {name} = value\n"
        f"{block(fails.splitlines(), 2)}\n        {name} = {name} + '_end'\n    {name} = {name} + '_behind'\n"
        f"except Exception as error:\n    {name} = {name} + '_' + type(error).__name__"
    )
    return name


def several(draft: Draft, scope: Scope, depth: int) -> str:
    """Two managers, one in the other or side by side."""
    name, outer, inner = draft.fresh("both"), manager(draft), manager(draft)
    head = draft.chooser.pick(
        [
            "with {o}({w}) as one, {i}('i') as two:\n        {n} = one + two\n        raise {e}({n})",
            "with {o}({w}) as one:\n        with {i}(one) as two:\n            {n} = two\n            raise {e}(one)\n        {n} = {n} + '_mid'",
            "with ({o}({w}) as one, {i}(one) as two):\n        {n} = two",
        ]
    ).format(o=outer, i=inner, n=name, w=word(draft, scope, depth), e=draft.chooser.pick(_FAILURES))
    scope.add(
        f"{name} = 'none'\ntry:\n    {head}\n    {name} = {name} + '_after'\nexcept Exception:\n    {name} = {name} + '_out'"
    )
    return name


def leaves(draft: Draft, scope: Scope, depth: int) -> str:
    """A block that is left by `return`, `break` or `continue`."""
    function, guard = draft.fresh("within"), manager(draft)
    body = draft.chooser.pick(
        [
            "with {g}(a) as value:\n    return value\nreturn 'unreached'",
            "with {g}(a) as value:\n    if {t}:\n        return value\n    raise KeyError(a)\nreturn a + '_swallowed'",
            "for x in (a, 'b', 'c'):\n    with {g}(x) as value:\n        if {t}:\n            break\n        continue\n    x = 'between'\nreturn x",
            "kept = 'k'\nfor x in (a, 'b'):\n    with {g}(x) as value:\n        kept = kept + value\n        raise ValueError(x)\n    kept = kept + '_t'\nreturn kept",
        ]
    ).format(g=guard, t=condition(draft, Scope(names=["a"]), 0))
    draft.define(
        f"def {function}(a):\n    try:\n{block(body.splitlines(), 2)}\n    except Exception as error:\n        return type(error).__name__"
    )
    return f"{function}({word(draft, scope, depth)})"


def stack(draft: Draft, scope: Scope, depth: int) -> str:
    """An ExitStack: what it enters, calls back and gives away."""
    name, text = draft.fresh("stacked"), word(draft, scope, depth)
    draft.need("import contextlib")
    body = draft.chooser.pick(
        [
            "    {n}.append(stack.enter_context({g}({w})))\n    stack.callback({n}.append, 'called')\n    {n}.append('in')",
            "    stack.callback({n}.append, {w})\n    stack.callback({n}.append, 'last')",
            "    for x in ({w}, 'two'):\n        {n}.append(stack.enter_context({g}(x)))",
            "    stack.push(lambda kind, error, trace: kind is KeyError)\n    {n}.append({w})\n    raise KeyError('gone')",
            "    stack.callback({n}.append, {w})\n    kept = stack.pop_all()\n    {n}.append('open')\nkept.close()",
            "    stack.enter_context(contextlib.suppress(KeyError))\n    {n}.append({w})\n    {{}}['no']\n    {n}.append('not')",
        ]
    ).format(n=name, w=text, g=manager(draft))
    scope.add(f"{name} = ['st']\nwith contextlib.ExitStack() as stack:\n{body}")
    return draft.chooser.pick([f"'_'.join({name})", f"{name}[-1]", f"{name}[len({name}) // 2]"])


def suppressed(draft: Draft, scope: Scope, depth: int) -> str:
    """`contextlib.suppress`, `nullcontext` and `closing`."""
    name, text = draft.fresh("quiet"), word(draft, scope, depth)
    draft.need("import contextlib")
    kinds = draft.chooser.pick(["KeyError", "LookupError, ValueError", "Exception", "*(KeyError, IndexError)"])
    scope.add(
        f"{name} = {text}\ntry:\n    with contextlib.suppress({kinds}):\n        {name} = {name} + '_in'\n"
        f"        if {condition(draft, scope, 0)}:\n            raise {draft.chooser.pick(_FAILURES)}({name})\n"
        f"        {name} = {name} + '_end'\nexcept Exception as error:\n    {name} = str(error.args[0]) + '_out'"
    )
    if draft.chooser.chance(30):
        scope.add(f"with contextlib.nullcontext({name}) as {name}n:\n    {name} = {name}n + '_null'")
    return name


def decorating(draft: Draft, scope: Scope, depth: int) -> str:
    """A manager as a decorator."""
    function, guard = draft.fresh("dressed"), draft.fresh("dress")
    draft.need("import contextlib")
    draft.define(
        f"@contextlib.contextmanager\ndef {guard}(trail):\n    trail.append('open')\n    try:\n        yield\n"
        f"    except KeyError:\n        trail.append('key')\n    trail.append('shut')\n\n\n{guard}_trail = []\n\n\n"
        f"@{guard}({guard}_trail)\ndef {function}(a, fail):\n    {guard}_trail.append(a)\n    if fail:\n        raise KeyError(a)\n    return a + '_r'"
    )
    scope.add(f"{guard}_got = {function}({word(draft, scope, depth)}, {condition(draft, scope, 0)}) or 'nothing'")
    return draft.chooser.pick([f"{guard}_got", f"'_'.join({guard}_trail)", f"{guard}_trail[-1]"])


# Entities


def made_within(draft: Draft, scope: Scope, depth: int) -> None:
    """Entities in a `with` before and behind a failure, and behind the block."""
    inside, later, behind = scope.inner("value"), scope.inner("value"), scope.inner()
    create(draft, inside, depth - 1)
    create(draft, later, 0)
    create(draft, behind, 0)
    fails = f"raise {draft.chooser.pick(_FAILURES)}({word(draft, scope, 0)})"
    if draft.chooser.chance(60):
        fails = f"if {condition(draft, scope, 0)}:\n    {fails}"
    scope.add(
        f"try:\n    with {manager(draft)}({word(draft, scope, 0)}) as value:\n"
        f"{block([*inside.lines, *fails.splitlines(), *later.lines], 2)}\n{block(behind.lines)}\n"
        "except (LookupError, RuntimeError, ValueError):\n    pass"
    )


def made_by_manager(draft: Draft, scope: Scope, _depth: int) -> None:
    """A manager that creates entities when it is entered and left."""
    cls, node = draft.fresh("Session"), scope.node
    draft.define(
        f"class {cls}:\n    def __init__(self, node, name):\n        self.node, self.name = node, name\n"
        "    def __enter__(self):\n        self.node.create_publisher(String, self.name + '_enter', 10)\n        return self\n"
        "    def __exit__(self, kind, error, trace):\n        how = 'fail' if kind else 'end'\n"
        "        self.node.create_publisher(String, self.name + '_' + how, 10)\n"
        f"        return {draft.chooser.pick(['False', 'True', 'kind is KeyError'])}"
    )
    inside = scope.inner("session.name")
    create(draft, inside, 0)
    fails = draft.chooser.pick(["pass", "raise KeyError('k')", "raise ValueError('v')"])
    draft.need("import contextlib")
    use = draft.chooser.pick(
        [
            f"with {cls}({node}, {word(draft, scope, 0)}) as session:\n{block([*inside.lines, fails])}",
            f"with contextlib.ExitStack() as stack:\n    session = stack.enter_context({cls}({node}, {word(draft, scope, 0)}))\n"
            f"    stack.callback({node}.create_publisher, String, 'closing', 10)\n{block([*inside.lines, fails])}",
        ]
    )
    scope.add(f"try:\n{block(use.splitlines())}\nexcept Exception:\n    pass")


WAYS: Final[tuple[Way, ...]] = (swallowed, swallowed, several, leaves, stack, suppressed, decorating)
STATEMENTS: Final[tuple[Statement, ...]] = (made_within, made_by_manager)
