# SPDX-License-Identifier: Apache-2.0
"""Threads: what runs in one, and what do locks and atomics matter?

std::thread(&Robot::run, this)      run may be called from now on, at any time
std::lock_guard lock(mutex);        nothing: every order of what runs is followed anyway
flag.store(true)                    the atomic is its value
"""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import External, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, NONE, TRUE, Const, Ref, Value
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.functional import kept
from rosward.models.cpp.values.conversions import convert
from rosward.models.cpp.values.copies import copied, write
from rosward.models.cpp.values.slots import read
from rosward.models.cpp.values.types import argument, name_of
from rosward.models.native import Machine, NativeCall, NativeFunction

__all__ = ["NATIVES", "OF_PLACES"]


def _opaque(machine: Machine, name: str) -> Ref:
    """An object of the library that has no say in what is found."""
    return machine.allocate(Obj("instance", External(name)), name)


def _thread(call: NativeCall) -> Value:
    """std::thread(callable, arguments…): copies of these are handed over."""
    machine, args = call.machine, call.args[1:]
    if args and not _is_thread(machine, args[0]):
        function = read(machine, args[0])
        machine.schedule(function, tuple(kept(machine, arg) for arg in args[1:]), "thread")
    elif args:
        return read(machine, args[0])
    return _opaque(machine, name_of(call.args[0]))


def _is_thread(machine: Machine, value: Value) -> bool:
    held = read(machine, value)
    return isinstance(held, Ref) and name_of(machine.obj(held).cls) in ("std.thread", "std.jthread", "boost.thread")


def _waited(call: NativeCall) -> Value:
    return call.machine.unknown(Cause.LIVE, call.name)


def _nothing(call: NativeCall) -> Value:
    del call
    return NONE


def _unsure(call: NativeCall) -> Value:
    """Whether a lock is had, a thread can be joined."""
    return call.machine.unknown(Cause.LIVE, call.name, "bool")


def _made(call: NativeCall) -> Value:
    return _opaque(call.machine, name_of(call.args[0]))


def _meanwhile(call: NativeCall) -> Value:
    """What waits, or takes time: other threads run."""
    call.machine.waits(others=True)
    return NONE


def _zero(call: NativeCall) -> Value:
    """The same, in C."""
    _meanwhile(call)
    return Const(0)


def _pthread(call: NativeCall) -> Value:
    """pthread_create(&thread, attributes, function, argument)"""
    machine = call.machine
    for function in call.args[2:3]:
        machine.schedule(read(machine, function), tuple(read(machine, arg) for arg in call.args[3:4]), "thread")
    return Const(0)


def _wait(call: NativeCall) -> Value:
    """condition.wait(lock, predicate): the predicate is asked."""
    call.machine.waits(others=True)
    for predicate in call.args[-1:] if len(call.args) > 2 else ():
        call.machine.call(read(call.machine, predicate), ())
    return call.machine.unknown(Cause.LIVE, call.name)


# Atomics: the value itself, in its slot


def _new_atomic(call: NativeCall) -> Value:
    wanted = argument(call.args[0], 0)
    value = call.args[1] if len(call.args) > 1 else Tuple(())
    return convert(call.machine, value, wanted)


def _load(call: NativeCall) -> Value:
    return read(call.machine, call.args[0])


def _store(call: NativeCall) -> Value:
    value = copied(call.machine, call.args[1]) if len(call.args) > 1 else TRUE
    old = read(call.machine, call.args[0])
    write(call.machine, call.args[0], value)
    return old


def _cleared(call: NativeCall) -> Value:
    write(call.machine, call.args[0], FALSE)
    return NONE


def _fetch(operator: str) -> NativeFunction:
    def compute(call: NativeCall) -> Value:
        machine = call.machine
        old = read(machine, call.args[0])
        write(machine, call.args[0], machine.binary(operator, old, read(machine, call.args[1])))
        return old

    return compute


def _compare_exchange(call: NativeCall) -> Value:
    """Where the value is the expected one, it becomes the other."""
    machine = call.machine
    same = machine.truth(machine.compare("==", read(machine, call.args[0]), read(machine, call.args[1])))
    if same is not False:
        write(machine, call.args[0], read(machine, call.args[2]), weak=same is None)
    if same is not True:
        write(machine, call.args[1], read(machine, call.args[0]), weak=same is None)
    return machine.unknown(Cause.LIVE, call.name, "bool") if same is None else Const(same)


_LOCKS: Final = (
    "mutex", "recursive_mutex", "timed_mutex", "recursive_timed_mutex", "shared_mutex", "shared_timed_mutex",
    "lock_guard", "unique_lock", "scoped_lock", "shared_lock", "condition_variable", "condition_variable_any",
    "once_flag", "stop_token", "stop_source", "barrier", "latch", "counting_semaphore",
)  # fmt: skip
_SILENT: Final = (
    "lock",
    "unlock",
    "lock_shared",
    "unlock_shared",
    "notify_one",
    "notify_all",
    "detach",
    "release",
)
_ASKED: Final = (
    "try_lock",
    "try_lock_for",
    "try_lock_until",
    "owns_lock",
    "joinable",
    "valid",
    "request_stop",
    "stop_requested",
)
_ATOMIC: Final[dict[str, NativeFunction]] = {
    "load": _load,
    **dict.fromkeys(("store", "exchange", "test_and_set"), _store),
    "clear": _cleared,
    **{f"fetch_{name}": _fetch(op) for name, op in {"add": "+", "sub": "-", "or": "|", "and": "&", "xor": "^"}.items()},
    **dict.fromkeys(("compare_exchange_strong", "compare_exchange_weak"), _compare_exchange),
    "is_lock_free": _unsure,
    **dict.fromkeys(("notify_one", "notify_all"), _nothing),
    "wait": _meanwhile,
}


_LEAST: Final = {
    **dict.fromkeys(
        (
            "fetch_add",
            "fetch_sub",
            "fetch_or",
            "fetch_and",
            "fetch_xor",
        ),
        2,
    ),
    **dict.fromkeys(
        (
            "compare_exchange_strong",
            "compare_exchange_weak",
        ),
        3,
    ),
}
OF_PLACES: Final = frozenset(f"std.atomic.{name}" for name in _ATOMIC)
NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"{space}.thread.new": _thread for space in ("std", "boost")},
    "std.jthread.new": _thread,
    **{f"std.{name}.new": _made for name in _LOCKS},
    **{f"std.{name}.{method}": _nothing for name in (*_LOCKS, "thread", "jthread") for method in _SILENT},
    **{f"std.{name}.{method}": _unsure for name in (*_LOCKS, "thread", "jthread") for method in _ASKED},
    **{f"std.{name}.join": _meanwhile for name in ("thread", "jthread")},
    **{f"std.{name}": _meanwhile for name in ("barrier.wait", "latch.wait", "counting_semaphore.acquire")},
    **{f"std.{name}.get_id": _waited for name in ("thread", "jthread")},
    **{
        f"std.condition_variable{kind}.{name}": _wait
        for kind in ("", "_any")
        for name in ("wait", "wait_for", "wait_until")
    },
    **{f"std.this_thread.{name}": _meanwhile for name in ("sleep_for", "sleep_until", "yield")},
    "std.this_thread.get_id": _waited,
    "std.thread.hardware_concurrency": _waited,
    **dict.fromkeys(("std.lock", "std.atomic_thread_fence"), _nothing),
    "std.atomic.new": _new_atomic,
    **{f"std.atomic.{name}": function for name, function in with_least(_ATOMIC, 1, _LEAST).items()},
    **dict.fromkeys(("std.usleep", "std.sleep", "std.nanosleep"), _meanwhile),
    **dict.fromkeys(("std.pthread_join", "std.pthread_cond_wait", "std.sem_wait"), _zero),
    "std.pthread_create": _pthread,
}
