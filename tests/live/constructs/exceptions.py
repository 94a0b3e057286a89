# SPDX-License-Identifier: Apache-2.0
"""What does an exception carry, and where does the program go on? Classes with data, causes, handlers that build names, `finally` that leaves.

try:
    raiser1("left")                   raises Error1("left"), perhaps `from` another one
except Error1 as error:
    caught1 = error.topic + "_x"
"""

from __future__ import annotations

from typing import Final

from ..draft import Draft, Scope, Statement, Way, block
from ..entities import create
from ..values import condition, word

_PLAIN: Final = "''.join(c for c in {} if c.isalnum() or c in '_/')"
_DATA: Final = (
    *("error.args[0]", "str(error.args[-1])", "'_'.join(map(str, error.args))", "type(error).__name__"),
    *("getattr(error, 'topic', 'untold')", "('x' + " + _PLAIN.format("str(error)") + ")"),
    *("('x' + " + _PLAIN.format("f'{error}'") + ")", "('x' + " + _PLAIN.format("repr(error)") + ")"),
    *("getattr(error, 'extra', 'plain')", "'_'.join(['n', *getattr(error, '__notes__', [])])"),
)
"""What a handler makes of its exception."""
_ORIGIN: Final = (
    *("type(error.__cause__).__name__", "type(error.__context__).__name__"),
    *("str((error.__cause__ or error).args[0])", "('hidden' if error.__suppress_context__ else 'shown')"),
)
"""What it makes of where the exception comes from."""


def kind(draft: Draft) -> str:
    """Define a class of exceptions that is called with one word; its name."""
    cls = draft.fresh("Error")
    own = draft.chooser.pick(
        [
            "    pass",
            "    def __init__(self, topic):\n        super().__init__(topic)\n        self.topic = topic",
            "    def __init__(self, topic, code=7):\n        super().__init__(topic, code)\n        self.topic = topic",
            "    def __init__(self, topic):\n        self.topic = topic + '_own'",
            "    topic = 'of_class'\n    def __str__(self):\n        return 'told_' + self.args[0]",
            "    def __init__(self, *parts):\n        super().__init__('_'.join(parts), 'more')\n        self.topic = parts[-1]",
            "    @property\n    def topic(self):\n        return self.args[0] + '_p'",
        ]
    )
    base = draft.chooser.pick(["Exception", "ValueError", "RuntimeError", "KeyError", "OSError"])
    if draft.chooser.chance(30):
        draft.define(f"class {cls}Base({base}):\n{own}\n\n\nclass {cls}({cls}Base):\n    pass")
    else:
        draft.define(f"class {cls}({base}):\n{own}")
    return cls


def raiser(draft: Draft, cls: str) -> str:
    """Define a function that raises it with what it is given; its name."""
    name = draft.fresh("raiser")
    body = draft.chooser.pick(
        [
            f"raise {cls}(a)",
            f"raise {cls}(a) from KeyError('cause')",
            f"raise {cls}(a) from None",
            f"try:\n    raise IndexError(a)\nexcept IndexError as first:\n    raise {cls}(first.args[0] + '_of') from first",
            f"try:\n    {{}}[a]\nexcept KeyError:\n    raise {cls}(a + '_in')",
            f"error = {cls}(a)\nerror.extra = a + '_set'\nraise error",
            f"error = {cls}(a)\nerror.add_note('noted')\nraise error",
            f"try:\n    raise {cls}(a)\nfinally:\n    a = a + '_late'",
            f"try:\n    raise {cls}(a)\nexcept {cls} as error:\n    error.extra = 'passed'\n    raise",
        ]
    )
    draft.define(f"def {name}(a):\n{block(body.splitlines())}")
    return name


def _caught_by(draft: Draft, cls: str) -> str:
    return draft.chooser.pick(
        [cls, cls, "Exception", f"(TypeError, {cls})", f"({cls} if __debug__ else KeyError)", f"({cls}, LookupError)"]
    )


def carried(draft: Draft, scope: Scope, depth: int) -> str:
    """A name that a handler makes of its exception."""
    name, cls = draft.fresh("caught"), kind(draft)
    inside = scope.inner(*draft.chooser.pick([_DATA, _ORIGIN]))
    value = word(draft, inside, depth)
    scope.add(
        f"{name} = 'never'\ntry:\n    {raiser(draft, cls)}({word(draft, scope, depth)})\n    {name} = 'unraised'\n"
        f"except {_caught_by(draft, cls)} as error:\n{block([*inside.lines, f'{name} = {value}'])}"
    )
    return name


def chosen(draft: Draft, scope: Scope, depth: int) -> str:
    """Several handlers, of which one fits, with `else` and `finally`."""
    name, one, two = draft.fresh("fit"), kind(draft), kind(draft)
    first, second = raiser(draft, one), raiser(draft, two)
    fits = draft.chooser.pick([one, two])
    scope.add(
        f"{name} = 'none'\ntry:\n    if {condition(draft, scope, 0)}:\n        {first}({word(draft, scope, depth)})\n"
        f"    elif {condition(draft, scope, 0)}:\n        {second}('second')\n    {name} = 'through'\n"
        f"except {fits} as error:\n    {name} = str(error.args[0]) + '_1'\n"
        f"except Exception as error:\n    {name} = str(error.args[0]) + '_2'\n"
        f"else:\n    {name} = {name} + '_else'\nfinally:\n    {name} = {name} + '_fin'"
    )
    return name


def again(draft: Draft, scope: Scope, depth: int) -> str:
    """An exception that passes several functions, each with something to do on its way."""
    name, outer, cls = draft.fresh("passed"), draft.fresh("passing"), kind(draft)
    way = draft.chooser.pick(
        [
            "except ValueError:\n    trail.append('value')\n    raise",
            "except LookupError as error:\n    trail.append('lookup')\n    raise RuntimeError(error.args[0]) from error",
            "finally:\n    trail.append('fin')",
            "except BaseException as error:\n    trail.append(type(error).__name__)\n    raise error",
        ]
    )
    draft.define(
        f"def {outer}(trail, a):\n    try:\n        {raiser(draft, cls)}(a)\n"
        f"{block(way.splitlines())}\n    trail.append('behind')"
    )
    scope.add(
        f"{name} = ['way']\ntry:\n    {outer}({name}, {word(draft, scope, depth)})\n"
        f"except Exception as error:\n    {name}.append(str(error.args[0]))"
    )
    return f"'_'.join({name})"


def leaving(draft: Draft, scope: Scope, depth: int) -> str:
    """A `finally` that returns, breaks or goes on, over what the block or its handler wanted."""
    function = draft.fresh("leaving")
    inside = Scope(names=["a"])
    test = condition(draft, inside, 0)
    way = draft.chooser.pick(
        [
            "try:\n    return a + '_try'\nfinally:\n    if {t}:\n        return a + '_fin'",
            "try:\n    raise KeyError(a)\nfinally:\n    if {t}:\n        return a + '_lost'\n    return 'else'",
            "for x in (a, 'b', 'c'):\n    try:\n        if {t}:\n            return x\n    finally:\n"
            "        if x == 'b':\n            break\nreturn x + '_loop'",
            "kept = 'k'\nfor x in (a, 'b'):\n    try:\n        raise ValueError(x)\n    except ValueError as error:\n"
            "        kept = kept + error.args[0]\n        continue\n    finally:\n        kept = kept + '_f'\nreturn kept",
            "kept = a\nwhile True:\n    try:\n        if {t}:\n            break\n        raise KeyError\n"
            "    except KeyError:\n        kept = kept + '_key'\n        break\n    finally:\n        kept = kept + '_f'\nreturn kept",
            "try:\n    try:\n        return a\n    finally:\n        int('x')\nexcept ValueError:\n    return a + '_value'",
        ]
    ).format(t=test)
    draft.define(f"def {function}(a):\n{block([*inside.lines, *way.splitlines()])}")
    return f"{function}({word(draft, scope, depth)})"


def turns(draft: Draft, scope: Scope, depth: int) -> str:
    """Exceptions in the iterations of a loop."""
    name, cls = draft.fresh("turned"), kind(draft)
    leave = draft.chooser.pick(["continue", "break", "pass"])
    inside = scope.inner("x", *_DATA)
    value = word(draft, inside, 0)
    scope.add(
        f"{name} = 'l'\nfor x in ({word(draft, scope, depth)}, 'mid', 'end'):\n    try:\n"
        f"        if {condition(draft, scope.inner('x'), 0)} or x == 'mid':\n            raise {cls}(x)\n"
        f"        {name} = x + '_ok'\n    except {cls} as error:\n"
        f"{block([*inside.lines, f'{name} = {value}', leave], 2)}\n    {name} = {name} + '_t'"
    )
    return name


def failing(draft: Draft, scope: Scope, depth: int) -> str:
    """What Python itself raises, and what it carries."""
    name, text = draft.fresh("failed"), word(draft, scope, depth)
    attempt, error, data = draft.chooser.pick(
        [
            (f"{{'k': 1}}[{text}]", "KeyError", "error.args[0]"),
            (f"next(iter([]), None) or next(iter(()))\n    {text}", "StopIteration", "('stop' + str(error.value))"),
            (f"[{text}][3]", "IndexError", "type(error).__name__"),
            (f"int({text} + 'q')", "(TypeError, ValueError)", "type(error).__name__"),
            (f"assert not {text}, {text}", "AssertionError", "str(error)"),
            (f"sys.exit({text})", "SystemExit", "str(error.code)"),
            (f"({text}).missing_here", "AttributeError", "error.name"),
            ("undefined_name_here", "NameError", "error.name"),
            (f"[].remove({text})", "ValueError", "type(error).__mro__[1].__name__"),
            (f"{{}}.popitem() + {text}", "LookupError", "type(error).__name__"),
            (f"one, two = [{text}]", "ValueError", "'few'"),
            (f"1 // (len({text}) * 0)", "ArithmeticError", "type(error).__name__"),
            (f"raise NotImplementedError({text})", "RuntimeError", "str(error)"),
        ]
    )
    draft.need("import sys")
    scope.add(f"{name} = 'fine'\ntry:\n    {attempt}\nexcept {error} as error:\n    {name} = {data}")
    return name


def grouped(draft: Draft, scope: Scope, depth: int) -> str:
    """Groups of exceptions and `except*`."""
    name, cls = draft.fresh("group"), kind(draft)
    scope.add(
        f"{name} = 'g'\ntry:\n    raise ExceptionGroup('both', [{cls}({word(draft, scope, depth)}), TypeError('t')])\n"
        f"except* {cls} as error:\n    {name} = {name} + str(error.exceptions[0].args[0])\n"
        f"except* TypeError as error:\n    {name} = {name} + '_' + error.exceptions[0].args[0]"
    )
    return name


def asked(draft: Draft, scope: Scope, depth: int) -> str:
    """An exception that is kept, asked for, or raised later."""
    name, cls = draft.fresh("kept"), kind(draft)
    draft.need("import sys")
    scope.add(
        draft.chooser.pick(
            [
                "{n} = None\ntry:\n    {r}({w})\nexcept {c} as error:\n    {n} = error\n{n} = str({n}.args[0])",
                "{n} = 'q'\ntry:\n    {r}({w})\nexcept {c}:\n    {n} = str(sys.exc_info()[1].args[0])",
                "{n} = []\ntry:\n    {r}({w})\nexcept {c} as error:\n    {n}.append(error)\n"
                "try:\n    raise {n}[0]\nexcept Exception as later:\n    {n} = str(later.args[0]) + '_later'",
                "{n} = {c}({w})\n{n} = '_'.join(map(str, {n}.args)) + '_unraised'",
            ]
        ).format(n=name, c=cls, r=raiser(draft, cls), w=word(draft, scope, depth))
    )
    return name


# Entities


def made_of_failure(draft: Draft, scope: Scope, depth: int) -> None:
    """Entities in a block that fails, in its handler with what the exception carries, in `else` and `finally`."""
    cls = kind(draft)
    first, caught, rest = scope.inner(), scope.inner(*_DATA), scope.inner()
    create(draft, first, depth - 1)
    create(draft, caught, depth - 1)
    create(draft, rest, 0)
    fails = f"{raiser(draft, cls)}({word(draft, scope, 0)})"
    if draft.chooser.chance(50):
        fails = f"if {condition(draft, scope, 0)}:\n    {fails}"
    tail = draft.chooser.pick(["else", "finally", ""])
    scope.add(
        f"try:\n{block([*first.lines, *fails.splitlines()])}\nexcept {_caught_by(draft, cls)} as error:\n"
        f"{block(caught.lines)}" + (f"\n{tail}:\n{block(rest.lines)}" if tail else "")
    )


def failing_turns(draft: Draft, scope: Scope, depth: int) -> None:
    """A loop in which some turns fail before their entity is made, some behind."""
    cls = kind(draft)
    before, behind = scope.inner("x"), scope.inner("x", *_DATA)
    create(draft, before, depth - 1)
    create(draft, behind, 0)
    scope.add(
        f"for x in ({word(draft, scope, 0)}, 'mid', 'end'):\n    try:\n"
        f"        if {condition(draft, scope.inner('x'), 0)}:\n            raise {cls}(x)\n{block(before.lines, 2)}\n"
        f"        if x == 'mid':\n            raise {cls}(x)\n    except {cls} as error:\n{block(behind.lines, 2)}\n"
        f"        {draft.chooser.pick(['break', 'continue', 'pass'])}"
    )


WAYS: Final[tuple[Way, ...]] = (carried, carried, chosen, again, leaving, turns, failing, grouped, asked)
STATEMENTS: Final[tuple[Statement, ...]] = (made_of_failure, failing_turns)
