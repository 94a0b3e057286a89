# SPDX-License-Identifier: Apache-2.0
"""`math` and `operator` on constants; `random`, `time`, `uuid`, `socket` and their like, which differ from run to run.

math.radians(180)              Const(3.14159…)
random.choice(['a', 'b'])      Choice('a', 'b')
f'client_{uuid.uuid4()}'       Text('client_', hole), the hole because of "time, random or host: uuid.uuid4"
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Final

from rosward.domain.choice import join_all
from rosward.domain.text import make, parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Const, Hole, Text, Unknown, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import int_of
from rosward.models.python.std.support import apply_plain, exact_list, joined_elements, origins_in, unknown_from
from rosward.models.python.strings.text_choices import are_letters

_INT_MATH: Final = ("ceil", "comb", "factorial", "floor", "gcd", "isqrt", "lcm", "perm", "trunc")
_BOOL_MATH: Final = ("isclose", "isfinite", "isinf", "isnan")
_FLOAT_MATH: Final = frozenset(
    """acos acosh asin asinh atan atan2 atanh cbrt copysign cos cosh degrees dist erf erfc exp exp2 expm1 fabs fmod
    frexp fsum gamma hypot ldexp lgamma log log10 log1p log2 modf nextafter pow prod radians remainder sin sinh sqrt
    tan tanh ulp""".split()  # noqa: SIM905 - a table reads better as one
)


def _math_hint(name: str) -> str:
    if name in _INT_MATH:
        return "int"
    if name in _BOOL_MATH:
        return "bool"
    return "tuple" if name in {"frexp", "modf"} else "" if name == "prod" else "float"


def _bounded(function: Callable[..., object]) -> Callable[..., object]:
    def apply(*values: Any) -> object:
        for value in values:
            if isinstance(value, int) and value.bit_length() > 1024:
                raise OverflowError("int too large to convert to float")
        return function(*values)

    return apply


def _math(call: NativeCall) -> Value:
    name = call.name.rpartition(".")[2]
    hint = _math_hint(name)
    function = getattr(math, name, None)
    if function is None or call.keywords:  # newer than the running Python, or start=/rel_tol=
        return unknown_from(call, hint, (*call.args, *call.keywords.values()))
    whole = name in {"comb", "factorial", "perm", "lcm", "prod", "gcd"}
    return apply_plain(call, function if whole else _bounded(function), call.args, hint)


_OPERATORS: Final = {
    "add": "+",
    "concat": "+",
    "sub": "-",
    "mul": "*",
    "truediv": "/",
    "floordiv": "//",
    "mod": "%",
    "pow": "**",
    "matmul": "@",
    "and_": "&",
    "or_": "|",
    "xor": "^",
    "lshift": "<<",
    "rshift": ">>",
}
_COMPARISONS: Final = {
    "eq": "==",
    "ne": "!=",
    "lt": "<",
    "le": "<=",
    "gt": ">",
    "ge": ">=",
    "is_": "is",
    "is_not": "is-not",
}


def _operator(call: NativeCall) -> Value:
    name = call.name.rpartition(".")[2]
    if len(call.args) != 2:
        return call.machine.die("TypeError", f"{name} expected 2 arguments")
    left, right = call.exactly(2)
    if name in _COMPARISONS:
        return call.machine.compare(_COMPARISONS[name], left, right)
    return call.machine.binary(_OPERATORS[name], left, right)


def _getitem(call: NativeCall) -> Value:
    return call.machine.load_item(call.args[0], call.args[1])


def _contains(call: NativeCall) -> Value:
    return call.machine.compare("in", call.args[1], call.args[0])


def _truth(call: NativeCall) -> Value:
    truth = call.machine.truth(call.args[0])
    if truth is None:
        return unknown_from(call, "bool", call.args)
    return Const(truth if call.name.endswith("truth") else not truth)


def _random(hint: str) -> NativeFunction:
    def draw(call: NativeCall) -> Value:
        return call.machine.unknown(Cause.RANDOM, call.name, hint)

    return draw


def _choice(call: NativeCall) -> Value:
    sequence = call.arg(0, "seq") or call.arg(0, "a")
    found = UNBOUND if sequence is None else joined_elements(call, sequence)
    if found is UNBOUND:
        return call.machine.die("IndexError", "Cannot choose from an empty sequence")
    return _drawn(call, found)


def _drawn(call: NativeCall, found: Value) -> Value:
    """One of what is drawn from: where it is one of many letters or texts, chance is why it is not known."""
    chance = call.machine.unknown(Cause.RANDOM, call.name, "str")
    if are_letters(found):
        return chance
    if isinstance(found, Text) or (isinstance(found, Unknown) and found.hint == "str"):
        of_chance = Hole(chance.reasons)
        return make([_by(p, of_chance) if isinstance(p, Hole) else p for p in parts_of(found)], origins_in((found,)))
    return found


def _by(hole: Hole, chance: Hole) -> Hole:
    return chance if all(r.cause is Cause.MANY for r in hole.reasons) else hole


def _choices(call: NativeCall) -> Value:
    population = call.arg(0, "population")
    if population is None:
        return call.machine.unknown(Cause.RANDOM, call.name, "list")
    found = joined_elements(call, population)
    return call.machine.new_list((), None if found is UNBOUND else _drawn(call, found))


def _shuffle(call: NativeCall) -> Value:
    items = exact_list(call.machine, call.args[0]) if call.args else None
    if items:
        found = joined_elements(call, call.args[0])
        for index in range(len(items)):
            call.machine.store_item(call.args[0], Const(index), found)
    return NONE


def _randrange(call: NativeCall) -> Value:
    """One of the numbers where there are few of them."""
    if len(call.args) in (1, 2) and not call.keywords:
        low = 0 if len(call.args) == 1 else int_of(call.args[0])
        high = int_of(call.args[-1])
        if low is not None and high is not None:
            stop = high + 1 if call.name.endswith("randint") else high
            if low < stop <= low + 16:
                return join_all(Const(n) for n in range(low, stop))
    return call.machine.unknown(Cause.RANDOM, call.name, "int")


def _none(_: NativeCall) -> Value:
    return NONE


_VARYING: Final = {
    "str": """platform.node platform.platform platform.system platform.machine platform.release platform.version
        platform.processor platform.python_version socket.gethostname socket.getfqdn socket.gethostbyname
        getpass.getuser
        time.ctime time.strftime time.asctime secrets.token_hex
        secrets.token_urlsafe locale.setlocale numpy.datetime64""",
    "float": """random.random random.uniform random.gauss random.normalvariate random.triangular random.betavariate
        random.expovariate time.time time.monotonic time.perf_counter time.process_time time.thread_time time.mktime
        numpy.random.random_sample""",
    "int": """random.getrandbits time.time_ns time.monotonic_ns time.perf_counter_ns uuid.getnode secrets.randbelow
        secrets.randbits os.getpid os.getppid os.getuid threading.get_ident threading.get_native_id os.cpu_count
        multiprocessing.cpu_count""",
    "bytes": "random.randbytes os.urandom secrets.token_bytes",
    "": """uuid.uuid1 uuid.uuid4
        datetime.datetime.now datetime.datetime.utcnow datetime.datetime.today datetime.date.today
        time.localtime time.gmtime numpy.random.random numpy.random.rand numpy.random.randn numpy.random.randint
        numpy.random.uniform numpy.random.normal numpy.random.default_rng random.Random random.SystemRandom""",
}

NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"math.{name}": _math for name in (*sorted(_FLOAT_MATH), *_INT_MATH, *_BOOL_MATH)},
    **{f"operator.{name}": _operator for name in (*_OPERATORS, *_COMPARISONS)},
    "operator.getitem": _getitem,
    "operator.contains": _contains,
    "operator.truth": _truth,
    "operator.not_": _truth,
    **{name: _random(hint) for hint, names in _VARYING.items() for name in names.split()},
    "random.choice": _choice,
    "secrets.choice": _choice,
    "random.choices": _choices,
    "random.sample": _choices,
    "random.shuffle": _shuffle,
    "random.randint": _randrange,
    "random.randrange": _randrange,
    "random.seed": _none,
    "time.tzset": _none,
}
