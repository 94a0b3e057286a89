# SPDX-License-Identifier: Apache-2.0
"""`<algorithm>` and `<numeric>`: what becomes of the elements between two iterators?

std::transform(s.begin(), s.end(), s.begin(), ::tolower)
v.erase(std::remove_if(v.begin(), v.end(), f), v.end())
std::accumulate(names.begin(), names.end(), std::string())

What a callable is asked is asked once for each element, or once for all of them where their number is not known.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.choice import join_all
from rosward.domain.compound import External, Partial
from rosward.domain.series import Series
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Const, Value
from rosward.models.cpp.algorithms.ranges import INSERTERS, emit, place, places, rewrite, whole_text
from rosward.models.cpp.algorithms.searching import tests
from rosward.models.cpp.arity import with_least
from rosward.models.cpp.containers.sorting import sorted_values
from rosward.models.cpp.iteration.arrays import decaying
from rosward.models.cpp.iteration.elements import between
from rosward.models.cpp.iteration.iterators import as_iterator, iterator, moved
from rosward.models.cpp.strings.string_parts import as_python
from rosward.models.cpp.values.copies import copied, for_each, several, write
from rosward.models.cpp.values.slots import read
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import int_of, text_of, unknown_from

__all__ = ["NATIVES"]

_CASES: Final = {"tolower": "lower", "toupper": "upper"}


def _for_each(call: NativeCall) -> Value:
    machine, function = call.machine, read(call.machine, call.args[2])
    for element in _in_turn(call):
        if machine.call(function, (element,)) is UNBOUND:
            return UNBOUND
    return function


def _in_turn(call: NativeCall) -> list[Value]:
    """The places of the elements, or one for all where their number is not known."""
    where = places(call.machine, call.args[0], call.args[1])
    if where is not None:
        return [place(call.machine, each) for each in where]
    element = between(call.machine, call.args[0], call.args[1], slots=True).element()
    return [] if element is None else [element]


def _transform(call: NativeCall) -> Value:
    machine = call.machine
    if len(call.args) == 5:
        return _transform_two(call)
    function = read(machine, call.args[3])
    whole = whole_text(machine, call.args[0], call.args[1])
    out = as_iterator(read(machine, call.args[2]))
    case = _CASES.get(function.name.rpartition(".")[2]) if isinstance(function, External) else None
    if whole is not None and out is not None and out.base == whole[0] and (case or text_of(whole[1]) is None):
        text = as_python(machine, case, whole[1]) if case else _asked_once(call, function, whole[1])
        write(machine, whole[0], text)
        return iterator(whole[0], NONE)
    where = places(machine, call.args[0], call.args[1])
    if where is None:
        element = between(machine, call.args[0], call.args[1], slots=True).element()
        made = Series((), None if element is None else several(machine, machine.call(function, (element,))))
    else:
        made = Series(tuple(machine.call(function, (place(machine, each),)) for each in where))
    return UNBOUND if UNBOUND in made.head else emit(machine, call.args[2], made.mapped(lambda v: read(machine, v)))


def _asked_once(call: NativeCall, function: Value, text: Value) -> Value:
    machine = call.machine
    machine.call(function, (unknown_from(machine, "character", "str", text),))
    return unknown_from(machine, "transform", "str", text)


def _transform_two(call: NativeCall) -> Value:
    machine, function = call.machine, read(call.machine, call.args[4])
    first = between(machine, call.args[0], call.args[1])
    second = read(machine, call.args[2])
    if not first.exact:
        given = first.element() or NONE, unknown_from(machine, "transform", "")
        made = Series((), several(machine, machine.call(function, given)))
    else:
        others = between(machine, second, moved(machine, second, Const(len(first.head))))
        pairs = zip(first.head, others.head, strict=False)
        made = Series(tuple(machine.call(function, pair) for pair in pairs))
    return UNBOUND if UNBOUND in made.head else emit(machine, call.args[3], made)


def _copy(call: NativeCall) -> Value:
    """copy, move, copy_if, remove_copy_if."""
    machine = call.machine
    series = between(machine, call.args[0], call.args[1])
    if call.name.endswith("_if"):
        answers = _answers_of(call, series, 3)
        series = _kept(series, answers)
    return emit(machine, call.args[2], series)


def _answers_of(call: NativeCall, series: Series, index: int) -> list[bool | None] | None:
    """What a callable says of each element; None where the number of these is not known."""
    function = read(call.machine, call.args[index])
    found = [call.machine.truth(call.machine.call(function, (value,))) for value in series.head]
    if series.exact:
        return found
    for value in (series.middle, *series.tail):
        if value is not None:
            call.machine.call(function, (value,))
    return None


def _kept(series: Series, answers: list[bool | None] | None, *, wanted: bool = True) -> Series:
    """The elements of which that is said."""
    if answers is None:
        return series.loose()
    kept = [v for v, answer in zip(series.head, answers, strict=True) if answer is not (not wanted)]
    return Series((), join_all(kept)) if None in answers else Series(tuple(kept))


def _remove(call: NativeCall) -> Value:
    """remove, remove_if, unique: those that stay come first; gives where they end."""
    machine = call.machine
    series = between(machine, call.args[0], call.args[1])
    last = read(machine, call.args[1])
    if call.name.endswith("unique"):
        answers = _repeats(call, series)
    else:
        test = tests(call, 2)
        answers = [test(place(machine, each)) for each in places(machine, call.args[0], call.args[1]) or ()]
        if not series.exact or len(answers) != len(series.head):
            element = series.element()
            answers = [None if element is None or test(element) is not False else False] * max(1, len(series.head))
    if None in answers or not series.exact:
        if not any(answer is not False for answer in answers):
            return last
        rewrite(machine, call.args[0], call.args[1], series.loose())
        slot = as_iterator(last)
        return iterator(slot.base, unknown_from(machine, call.name, "int", series.element())) if slot else last
    kept = [v for v, gone in zip(series.head, answers, strict=True) if not gone]
    rewrite(machine, call.args[0], call.args[1], Series((*kept, *series.head[len(kept) :])))
    return moved(machine, read(machine, call.args[0]), Const(len(kept)))


def _repeats(call: NativeCall, series: Series) -> list[bool | None]:
    """Whether each element is the same as the one before."""
    machine = call.machine
    if not series.exact:
        return [None]
    pairs = zip(series.head, series.head[1:], strict=False)
    found = [machine.truth(machine.compare("==", a, b)) for a, b in pairs]
    return [False, *found][: len(series.head)]


def _replace(call: NativeCall) -> Value:
    """replace, replace_if."""
    machine = call.machine
    whole = whole_text(machine, call.args[0], call.args[1])
    if whole is not None and not call.name.endswith("_if"):
        old, new = (read(machine, arg) for arg in call.args[2:4])
        write(machine, whole[0], as_python(machine, "replace", whole[1], old, new))
        return NONE
    series = between(machine, call.args[0], call.args[1])
    test = tests(call, 2)
    fresh = read(machine, call.args[3])

    def one(value: Value) -> Value:
        answer = test(value)
        return (
            copied(machine, fresh)
            if answer
            else value
            if answer is False
            else join_all((value, copied(machine, fresh)))
        )

    rewrite(machine, call.args[0], call.args[1], for_each(machine, series, one))
    return NONE


def _fill(call: NativeCall) -> Value:
    machine = call.machine
    return _rewritten(call, lambda: copied(machine, call.args[2]))


def _rewritten(call: NativeCall, make: Callable[[], Value]) -> Value:
    """Each element of a range becomes one that is made for it."""
    made = for_each(call.machine, between(call.machine, call.args[0], call.args[1]), lambda _: make())
    rewrite(call.machine, call.args[0], call.args[1], made)
    return NONE


def _fill_n(call: NativeCall) -> Value:
    machine = call.machine
    count = int_of(read(machine, call.args[1]))
    generate = call.name.endswith("generate_n")
    function = read(machine, call.args[2])

    def one() -> Value:
        return machine.call(function, ()) if generate else copied(machine, function)

    known = count is not None and 0 <= count <= 1_000
    return emit(
        machine,
        call.args[0],
        Series(tuple(one() for _ in range(count or 0))) if known else Series((), several(machine, one())),
    )


def _generate(call: NativeCall) -> Value:
    machine, function = call.machine, read(call.machine, call.args[2])
    return _rewritten(call, lambda: machine.call(function, ()))


def _iota(call: NativeCall) -> Value:
    machine, series = call.machine, between(call.machine, call.args[0], call.args[1])
    start = read(machine, call.args[2])
    if series.exact:
        made = Series(tuple(machine.binary("+", start, Const(n)) for n in range(len(series.head))))
    else:
        made = Series((), machine.unknown(Cause.OPERATION, "iota", "int"))
    rewrite(machine, call.args[0], call.args[1], made)
    return NONE


def _reverse(call: NativeCall) -> Value:
    rewrite(call.machine, call.args[0], call.args[1], between(call.machine, call.args[0], call.args[1]).reversed())
    return NONE


def _rotate(call: NativeCall) -> Value:
    machine = call.machine
    before, after = between(machine, call.args[0], call.args[1]), between(machine, call.args[1], call.args[2])
    exact = before.exact and after.exact
    whole = between(machine, call.args[0], call.args[2])
    rewrite(machine, call.args[0], call.args[2], Series((*after.head, *before.head)) if exact else whole.loose())
    return moved(machine, read(machine, call.args[0]), Const(len(after.head))) if exact else read(machine, call.args[1])


def _sort(call: NativeCall) -> Value:
    machine = call.machine
    last = 2 if call.name.endswith(("partial_sort", "nth_element")) else 1
    series = between(machine, call.args[0], call.args[last])
    function = read(machine, call.args[last + 1]) if len(call.args) > last + 1 else None
    rewrite(machine, call.args[0], call.args[last], sorted_values(machine, series, function))
    return NONE


def _shuffle(call: NativeCall) -> Value:
    series = between(call.machine, call.args[0], call.args[1])
    anything = series.element()
    mixed = Series((anything,) * len(series.head)) if series.exact and anything is not None else series.loose()
    rewrite(call.machine, call.args[0], call.args[1], mixed)
    return NONE


def _accumulate(call: NativeCall) -> Value:
    machine = call.machine
    total = copied(machine, call.args[2]) if len(call.args) > 2 else Const(0)
    function = read(machine, call.args[3]) if len(call.args) > 3 else None
    series = between(machine, call.args[0], call.args[1])

    def add(left: Value, right: Value) -> Value:
        return machine.binary("+", left, right) if function is None else machine.call(function, (left, right))

    for value in series.head:
        total = read(machine, add(total, value))
        if total is UNBOUND:
            return UNBOUND
    if series.middle is not None:
        more = add(total, series.middle)
        hint = "str" if text_of(total) is not None else "int" if int_of(total) is not None else ""
        return unknown_from(machine, "accumulate", getattr(more, "hint", "") or hint, total, series.middle)
    return total


def _inserter(call: NativeCall) -> Value:
    return Partial(External(call.name), call.args, ())


def _output(call: NativeCall) -> Value:
    """std::ostream_iterator<T>(stream, separator): the type comes first."""
    return Partial(External("std.ostream_iterator"), call.args[1:], ())


def _partition(call: NativeCall) -> Value:
    machine = call.machine
    series = between(machine, call.args[0], call.args[1])
    answers = _answers_of(call, series, 2)
    if answers is None or None in answers:
        rewrite(machine, call.args[0], call.args[1], series.loose())
        slot = as_iterator(read(machine, call.args[0]))
        return iterator(slot.base, machine.unknown(Cause.OPERATION, "partition", "int")) if slot else NONE
    front = [v for v, answer in zip(series.head, answers, strict=True) if answer]
    back = [v for v, answer in zip(series.head, answers, strict=True) if not answer]
    rewrite(machine, call.args[0], call.args[1], Series((*front, *back)))
    return moved(machine, read(machine, call.args[0]), Const(len(front)))


_LEAST: Final = {
    **dict.fromkeys(
        ("unique", "reverse", "sort", "stable_sort", "shuffle", "random_shuffle", "accumulate", "reduce"), 2
    ),
    **dict.fromkeys(("transform", "copy_if", "replace", "replace_if"), 4),
}
_FUNCTIONS: Final[dict[str, NativeFunction]] = {
    "for_each": _for_each,
    "transform": _transform,
    **dict.fromkeys(("copy", "copy_if"), _copy),
    **dict.fromkeys(("remove", "remove_if", "unique"), _remove),
    **dict.fromkeys(("replace", "replace_if"), _replace),
    "fill": _fill,
    **dict.fromkeys(("fill_n", "generate_n"), _fill_n),
    "generate": _generate,
    "iota": _iota,
    "reverse": _reverse,
    "rotate": _rotate,
    **dict.fromkeys(("sort", "stable_sort", "partial_sort", "nth_element"), _sort),
    **dict.fromkeys(("shuffle", "random_shuffle"), _shuffle),
    **dict.fromkeys(("accumulate", "reduce"), _accumulate),
    **dict.fromkeys(("partition", "stable_partition"), _partition),
}

NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"std.{name}": decaying(function) for name, function in with_least(_FUNCTIONS, 3, _LEAST).items()},
    **with_least({name: _inserter for name in INSERTERS if name != "std.ostream_iterator"}, 1),
    **with_least({"std.ostream_iterator.new": _output}, 2),
}
