# SPDX-License-Identifier: Apache-2.0
"""`str.translate` and `str.maketrans`: a table is a dict of character codes.

Text('a-', hole).translate(str.maketrans('-', '_'))         Text('a_', hole)
"""

from __future__ import annotations

from typing import Final

from rosward.domain.text import make, parts_of
from rosward.domain.values import Const, Ref, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.plain import (
    NOT_PLAIN,
    from_python,
    int_of,
    native,
    origins,
    plain,
    run,
    spread,
    text_of,
    unknown_from,
)
from rosward.models.python.strings import text_parts


def _translate(call: NativeCall) -> Value:
    """text.translate(table)."""
    table = _table(call.machine, call.args[1])
    if table is None:
        return unknown_from(call.machine, "str.translate", "str", *call.args)

    def one(text: Value) -> Value:
        parts = tuple(p.translate(table) if isinstance(p, str) else text_parts.loose(p) for p in parts_of(text))
        return make(parts, origins(text))

    return spread(one, call.args[0])


def _table(machine: Machine, value: Value) -> dict[int, str | int | None] | None:
    """The translation table that a dict surely is."""
    obj = machine.obj(value) if isinstance(value, Ref) else None
    if obj is None or obj.kind != "dict" or obj.rest is not None or obj.maybe or obj.many:
        return None
    table: dict[int, str | int | None] = {}
    for key, item in obj.entries.items():
        code, target = int_of(key), plain(item)
        if code is None or not (target is None or isinstance(target, (str, int))):
            return None
        table[code] = target
    return table


def _maketrans(call: NativeCall) -> Value:
    """str.maketrans(from, to, remove) or of a dict of characters."""
    args = call.args
    if len(args) > 1 and args[0] == Const("") != args[1]:
        args = args[1:]  # called on an instance: ''.maketrans(…)
    if len(args) == 1 and isinstance(args[0], Ref):
        obj = call.machine.obj(args[0])
        if obj.kind == "dict" and obj.rest is None and not obj.maybe and not obj.many:
            codes = {k: int_of(k) if text_of(k) is None else ord((text_of(k) or "\0")[0]) for k in obj.entries}
            return call.machine.new_dict({Const(codes[k]): v for k, v in obj.entries.items()})
    operands = [plain(v) for v in args]
    if NOT_PLAIN in operands:
        return unknown_from(call.machine, "str.maketrans", "dict", *args)
    return from_python(call.machine, run(str.maketrans, *operands), origins(*args), "str.maketrans")


TRANSLATE_NATIVES: Final[dict[str, NativeFunction]] = {
    "str.translate": native(_translate, 2),
    "str.maketrans": native(_maketrans, 1),
}
