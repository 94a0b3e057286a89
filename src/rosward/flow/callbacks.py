# SPDX-License-Identifier: Apache-2.0
"""A callback is called, with what it was made of: what arrives, what a partial function gives it, and its defaults.

partial(self.on, name)               `name` is the first argument, what arrives is the second
lambda msg, t=name: self.send(t)     `name` is the default of `t`
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from rosward.engine.arguments import MAYBE
from rosward.flow import library
from rosward.flow.body import Body
from rosward.flow.bound import in_parameters
from rosward.flow.calls import keep_arguments, resume
from rosward.flow.marks import NOTHING, Mark
from rosward.flow.native import natives
from rosward.flow.native.partials import Given, bound_in
from rosward.flow.ways import Way, each_way, joined_marks

if TYPE_CHECKING:
    from rosward.engine.running.seen import Activation, Called, Performed
    from rosward.flow.walker import Walker


def begin(
    walker: Walker,
    activation: Activation,
    arguments: list[Mark],
    callback: Mark,
    given: int,
    pc: int,
    handed: Sequence[Mark] = (),
) -> Mark:
    """A callback is called as it was registered, with these arguments behind what it has; what else it may be given depends on `given`.

    `handed`: what a library calls it with, of which the interpretation knows nothing.
    """
    body = Body(activation, [], pc)
    seen = activation.of(0)
    walker.bodies.append(body)
    try:
        waiting = walker.bodies_of(seen)
        ways: list[Way] = []
        called_here: set[str] = set()
        for key, several in walker.sites.by_code(seen).items():
            function = several[0].function
            code = function.code
            marks = joined_marks(
                [_of_callback(walker, body, called, arguments, callback, given, handed) for called in several]
            )
            if code.is_generator or code.is_coroutine:
                keep_arguments(walker, key, marks)
                continue
            called_here.add(key)
            if code.is_stub:
                ways.append(partial(library.declared, walker, body, function, marks))
            ways += [partial(walker.enter, activated, marks, pc) for activated in waiting.get(key, ())]
        for key, activations in waiting.items():
            if key not in called_here:
                ways += [partial(resume, walker, activation.code.entry, body, a, pc) for a in activations]
        ways += [partial(_native, walker, body, n, arguments, callback, given, handed) for n in seen.performed.values()]
        result = each_way(walker, ways)
        return NOTHING if result is None else result.under(pc)
    finally:
        walker.bodies.pop()


def _native(
    walker: Walker,
    body: Body,
    native: Performed,
    arguments: list[Mark],
    callback: Mark,
    given: int,
    handed: Sequence[Mark],
) -> Mark:
    """A builtin, or a model in code, is the callback."""
    partials = Given(walker, bound_in(callback))
    first = len(native.args) - len(arguments)
    before = partials.whole.under(given)
    marks = [before.joined(Mark(0, frozenset(passed.refs))) for passed in native.args[: max(first, 0)]]
    marks += [*(a.under(given) for a in arguments), *(h.under(given | body.pc) for h in handed)]
    named = {n.removeprefix(MAYBE): before.joined(Mark(0, frozenset(h.refs))) for n, h in native.keywords}
    return natives.perform(walker, body.at, body, body.activation.of(0), native, marks, named)


def _of_callback(
    walker: Walker,
    body: Body,
    called: Called,
    arguments: list[Mark],
    callback: Mark,
    given: int,
    handed: Sequence[Mark],
) -> list[Mark]:
    """What stands in the parameters of a callback: its receiver, what a partial function gives, what it is called with."""
    partials = Given(walker, bound_in(callback))
    first = len(called.args) - len(arguments)
    receivers = int(bool(called.args) and bool(called.args[0].refs) and first > 0 and partials.positional < first)
    marks = []
    for number, passed in enumerate(called.args):
        own = Mark(body.pc, frozenset(passed.refs))
        if first < 0:
            own = own.under(given)
        elif number >= first:
            own = own.joined(arguments[number - first])
        elif number >= receivers:
            own = own.joined(partials.at(number - receivers, first - receivers))
        marks.append(own)
    marks += [argument.under(given | body.pc) for argument in handed]
    named = {name: Mark(body.pc, frozenset(h.refs)).joined(partials.named(name)) for name, h in called.keywords}
    made = Mark(body.pc | given | callback.mask)
    return in_parameters(walker, body, 0, called.function, marks, named, made)
