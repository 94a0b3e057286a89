# SPDX-License-Identifier: Apache-2.0
"""`<random>`: engines and distributions give numbers of their kind, of which no more is known."""

from __future__ import annotations

from typing import Final

from rosward.domain.compound import External
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, Value
from rosward.models.cpp.values.types import argument, hint_of, name_of
from rosward.models.native import NativeCall, NativeFunction

__all__ = ["NATIVES"]

_ENGINES: Final = ("mt19937", "mt19937_64", "default_random_engine", "minstd_rand", "random_device", "seed_seq")
_WHOLE: Final = (
    "uniform_int_distribution",
    "bernoulli_distribution",
    "poisson_distribution",
    "discrete_distribution",
    "binomial_distribution",
)
_REAL: Final = ("uniform_real_distribution", "normal_distribution", "exponential_distribution", "gamma_distribution")


def _new(hint: str) -> NativeFunction:
    """An engine or distribution: something that can be called."""

    def make(call: NativeCall) -> Value:
        own = hint_of(argument(call.args[0], 0)) if name_of(argument(call.args[0], 0)) != "auto" else ""
        return External(f"std.random.{own if own in ('int', 'float') else hint}")

    return make


def _number(hint: str) -> NativeFunction:
    return lambda call: call.machine.unknown(Cause.RANDOM, "std.random", hint)


def _nothing(call: NativeCall) -> Value:
    del call
    return NONE


NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"std.{name}.new": _new("int") for name in (*_ENGINES, *_WHOLE)},
    **{f"std.{name}.new": _new("float") for name in _REAL},
    **{f"std.random.{hint}": _number(hint) for hint in ("int", "float")},
    **{
        f"std.random.{hint}.{name}": _number(hint) for hint in ("int", "float") for name in ("operator()", "min", "max")
    },
    **{
        f"std.random.{hint}.{name}": _nothing
        for hint in ("int", "float")
        for name in ("seed", "reset", "param", "discard")
    },
}
