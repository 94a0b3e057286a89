# SPDX-License-Identifier: Apache-2.0
"""Python, as the engine asks for it: one record of the functions in the modules beside this one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.values import Value
from rosward.engine.machine import Language
from rosward.engine.python import (
    abandoned,
    assignment,
    attributes,
    calls,
    contexts,
    equality,
    failing,
    generators,
    implicit,
    instances,
    items,
    iteration,
    members,
    modules,
    namespaces,
    own_methods,
    raised,
    removal,
    stepping,
)
from rosward.engine.python.transfer import OWN
from rosward.engine.running.stepped import Resumption
from rosward.engine.transfer import CORE
from rosward.ir.program import PYTHON as NAME

if TYPE_CHECKING:
    from rosward.engine.machine import Engine
    from rosward.models.native import ResumptionKind

__all__ = ["PYTHON"]


def _next_of(machine: Engine, iterator: Value, kind: ResumptionKind, value: Value, default: Value | None) -> Value:
    """The next item of an iterator, or the default, else StopIteration."""
    item = stepping.next_of(machine, iterator, Resumption(kind, value), default)
    abandoned.watch(machine, iterator)
    return item


def _raised(machine: Engine, exception: Value) -> Value:
    """An exception that is raised while another may be handled."""
    made = raised.made(machine, exception)
    raised.chain(machine, made, None)
    return made


PYTHON: Final = Language(
    name=NAME,
    table={**CORE, **OWN},
    situation=lambda _: None,
    instance=lambda *_: None,
    run_noting=failing.run_noting,
    cells_outlive=True,
    recalls=True,
    truth=equality.truth,
    unary=equality.unary,
    binary=equality.binary,
    compare=equality.compare,
    may=equality.may,
    is_instance=instances.is_instance,
    is_subclass=instances.is_subclass,
    load_attr=attributes.load,
    store_attr=assignment.store,
    keep_attr=assignment.keep,
    delete_attr=removal.delete,
    lookup=members.lookup,
    bind=members.bind,
    load_item=items.load,
    store_item=items.store,
    call=calls.call,
    call_with=calls.call_with,
    call_native=calls.call_native,
    call_function=calls.call_function,
    call_method=calls.call_method,
    is_open=own_methods.is_open,
    own_methods=own_methods.own_methods,
    implicit_calls=implicit.callbacks,
    iterate=iteration.iterate,
    series=iteration.series,
    is_stepped=stepping.is_followed,
    next_of=_next_of,
    wait_for=calls.wait_for,
    make_generator=generators.make,
    advance=generators.advance,
    run_out=generators.run_out,
    close_generator=generators.close,
    run_module=modules.run_module,
    run_packages=modules.run_packages,
    load_module=modules.load,
    load_asked=modules.load_asked,
    load_global=modules.load_quietly,
    variables=namespaces.variables,
    raised=_raised,
    class_of=raised.class_of,
    fail=raised.fail,
    builtin_error=raised.builtin_error,
    guarded=raised.guarded,
    unwind=contexts.unwind,
)
