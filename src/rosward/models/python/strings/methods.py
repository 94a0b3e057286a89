# SPDX-License-Identifier: Apache-2.0
"""The methods of `str` and `bytes`: Python's own on constants; on texts with holes, what stays known.

'a/b'.split('/')                        ['a', 'b']
Text('/Robot_', hole).lower()           Text('/robot_', hole)
Text('/', hole, '/x').removeprefix('/') Text(hole, '/x')
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from rosward.domain.choice import join_all
from rosward.domain.compound import Tuple
from rosward.domain.text import make, parts_of
from rosward.domain.unknown import Cause
from rosward.domain.values import EMPTY, FALSE, NONE, TRUE, Const, Hole, Text, Unknown, Value
from rosward.models.native import Machine, NativeCall, NativeFunction
from rosward.models.python.containers.any_order import each_order
from rosward.models.python.contents import text_data
from rosward.models.python.plain import (
    NOT_PLAIN,
    Raised,
    affordable,
    all_of,
    exact_list,
    from_python,
    hole_from,
    int_of,
    listed,
    native,
    origins,
    plain,
    run,
    spread,
    text_of,
    unknown_from,
    with_origins,
)
from rosward.models.python.strings import text_parts
from rosward.models.python.strings.formatting import FORMAT_NATIVES, format_value, joined
from rosward.models.python.strings.text_parts import Parts
from rosward.models.python.strings.translate import TRANSLATE_NATIVES

__all__ = ["NATIVES", "format_value"]

Arguments = tuple[Value, ...]
_RESULTS: Final = {
    "bool": "startswith endswith isalnum isalpha isascii isdecimal isdigit isidentifier islower isnumeric isprintable "
    "isspace istitle isupper",
    "int": "find index rfind rindex count",
    "list": "split rsplit splitlines",
    "tuple": "partition rpartition",
    "bytes": "encode",
    "str": "upper lower title capitalize swapcase casefold strip lstrip rstrip removeprefix removesuffix replace zfill "
    "ljust rjust center expandtabs",
}
_HINTS: Final = {name: hint for hint, names in _RESULTS.items() for name in names.split()}
_BYTES: Final = {
    "startswith": "bool", "endswith": "bool", "isdigit": "bool",
    "find": "int", "index": "int", "count": "int", "rfind": "int",
    "split": "list", "rsplit": "list", "splitlines": "list", "partition": "tuple", "rpartition": "tuple",
    "decode": "str", "hex": "str",
    "upper": "bytes", "lower": "bytes", "strip": "bytes", "lstrip": "bytes", "rstrip": "bytes", "replace": "bytes",
    "removeprefix": "bytes", "removesuffix": "bytes",
}  # fmt: skip
_NAMES: Final = {
    "split": ("sep", "maxsplit"),
    "rsplit": ("sep", "maxsplit"),
    "splitlines": ("keepends",),
    "encode": ("encoding", "errors"),
    "decode": ("encoding", "errors"),
    "expandtabs": ("tabsize",),
    "replace": ("old", "new", "count"),
}
_DEFAULTS: Final[dict[str, Value]] = {"sep": NONE, "encoding": Const("utf-8")}
_LEAST: Final = {
    **dict.fromkeys(
        ["partition", "rpartition", "startswith", "endswith", "find", "index", "rfind", "rindex", "count"], 2
    ),
    **dict.fromkeys(["removeprefix", "removesuffix", "zfill", "ljust", "rjust", "center"], 2),
    "replace": 3,
}
_EVERY_CHARACTER: Final = (
    "isalnum",
    "isalpha",
    "isascii",
    "isdecimal",
    "isdigit",
    "isnumeric",
    "isprintable",
    "isspace",
)


def _positional(call: NativeCall, name: str) -> Arguments:
    """The arguments in order, those given by name too."""
    if not call.keywords:
        return call.args
    args = list(call.args)
    for number, parameter in enumerate(_NAMES.get(name, ()), 1):
        if parameter in call.keywords:
            while len(args) < number:
                args.append(_DEFAULTS.get(_NAMES[name][len(args) - 1], NONE))
            args.append(call.keywords[parameter])
    return tuple(args)


def _method(call: NativeCall) -> Value:
    kind, _, name = call.name.rpartition(".")
    own = bytes if kind == "bytes" else str
    return spread(lambda *values: _apply(call.machine, own, name, values), *_positional(call, name))


def _apply(machine: Machine, kind: type, name: str, values: Arguments) -> Value:
    what = f"{kind.__name__}.{name}"
    operands = [plain(v) for v in values]
    if NOT_PLAIN not in operands:
        if not affordable(machine, what, operands):
            return machine.unknown(Cause.LIMIT, what, _HINTS.get(name, "bytes"))
        return from_python(machine, run(getattr(kind, name), *operands), origins(*values), what)
    handler = _HANDLERS.get(name) if kind is str else None
    if handler is not None and _is_text(values[0]):
        known = handler(machine, name, parts_of(values[0]), values[1:])
        if known is not None:
            return with_origins(known, origins(*values))
    hints = _BYTES if kind is bytes else _HINTS
    return _not_known(machine, what, hints[name], kind.__name__, values)


def _is_text(value: Value) -> bool:
    return value.__class__ in (Text, Unknown) or text_of(value) is not None


def _not_known(machine: Machine, what: str, hint: str, kind: str, values: Arguments) -> Value:
    """An unknown result of the right type."""
    if hint == "list":
        return listed(machine, what, (), unknown_from(machine, what, kind, *values))
    if hint == "tuple":
        return Tuple((unknown_from(machine, what, kind, *values),) * 3)
    return unknown_from(machine, what, hint, *values)


def _alternatives(found: list[Parts]) -> Value:
    if len(found) > text_parts.MAX_RESULTS:
        return make((text_parts.anything(tuple(p for parts in found for p in parts)),))
    anything = next((p for p in found if len(p) == 1 and isinstance(p[0], Hole) and not p[0].shape), None)
    return make(anything) if anything is not None else join_all(make(parts) for parts in found)


def _case(_machine: Machine, name: str, parts: Parts, _args: Arguments) -> Value:
    return make(text_parts.change_case(parts, name))


def _strip(_machine: Machine, name: str, parts: Parts, args: Arguments) -> Value | None:
    chars = args[0] if args else NONE
    if chars != NONE and text_of(chars) is None:
        return None
    wanted = text_of(chars)
    found = [parts] if name == "rstrip" else text_parts.strip_left(parts, wanted)
    if name != "lstrip":
        found = list(dict.fromkeys(q for p in found for q in text_parts.strip_right(p, wanted)))
    return _alternatives(found)


def _remove(_machine: Machine, name: str, parts: Parts, args: Arguments) -> Value | None:
    affix = text_of(args[0])
    if affix is None:
        return None
    if name == "removesuffix":
        backwards = text_parts.mirror(parts)
        found = [text_parts.mirror(p) for p in text_parts.remove_front(backwards, affix[::-1])]
        sure = text_parts.starts_with(backwards, affix[::-1])
    else:
        found, sure = text_parts.remove_front(parts, affix), text_parts.starts_with(parts, affix)
    return _alternatives(found if sure else [parts, *found])


def _replace(_machine: Machine, _name: str, parts: Parts, args: Arguments) -> Value | None:
    old, count = text_of(args[0]), int_of(args[2]) if len(args) > 2 else -1
    if not old or count is None or not _is_text(args[1]):
        return None
    return make(text_parts.replace(parts, old, parts_of(args[1]), count))


def _split(machine: Machine, name: str, parts: Parts, args: Arguments) -> Value | None:
    separator, limit = text_of(args[0]) if args else None, int_of(args[1]) if len(args) > 1 else -1
    if not separator or limit is None:
        return None
    if limit < 0:
        everything = text_parts.split_all(parts, separator)
        if everything is not None:
            return exact_list(machine, tuple(make(p) for p in everything))
    cut = text_parts.cut_front if name == "split" else text_parts.cut_back
    pieces: list[Value] = []
    while len(pieces) != limit:
        found = cut(parts, separator)
        if found is None:
            break
        piece, parts = found if name == "split" else (found[1], found[0])
        pieces.append(make(piece))
    exact = len(pieces) == limit or text_parts.split_all(parts, separator) == [parts]
    if exact:
        pieces.append(make(parts))
        return exact_list(machine, tuple(pieces if name == "split" else pieces[::-1]))
    return listed(machine, f"str.{name}", (), join_all([*pieces, make((text_parts.anything(parts),))]))


def _partition(_machine: Machine, name: str, parts: Parts, args: Arguments) -> Value | None:
    separator = text_of(args[0])
    if not separator:
        return None
    first = name == "partition"
    found = (text_parts.cut_front if first else text_parts.cut_back)(parts, separator)
    if found is not None:
        return Tuple((make(found[0]), Const(separator), make(found[1])))
    if text_parts.split_all(parts, separator) == [parts]:
        return Tuple((make(parts), EMPTY, EMPTY) if first else (EMPTY, EMPTY, make(parts)))
    seen = parts if first else text_parts.mirror(parts)
    edge = text_parts.before_place(seen, separator if first else separator[::-1])
    other = make((text_parts.anything(parts),))
    middle = join_all((Const(separator), EMPTY))
    return Tuple((make(edge), middle, other) if first else (other, middle, make(text_parts.mirror(edge))))


def _starts(_machine: Machine, name: str, parts: Parts, args: Arguments) -> Value | None:
    wanted = plain(args[0])
    affixes = wanted if isinstance(wanted, tuple) else (wanted,)
    if len(args) > 1 or not all(isinstance(a, str) for a in affixes):
        return None
    if name == "endswith":
        parts, affixes = text_parts.mirror(parts), tuple(str(a)[::-1] for a in affixes)
    answers = {text_parts.starts_with(parts, str(a)) for a in affixes}
    if True in answers:
        return TRUE
    return None if None in answers else FALSE


def _pad(machine: Machine, name: str, parts: Parts, args: Arguments) -> Value | None:
    """Fill up to a width: a hole where the filling comes."""
    fill = text_parts.anything(parts)
    known = sum(len(p) for p in parts if isinstance(p, str))
    width = int_of(args[0])
    if width is not None and known >= width:
        return make(parts)
    if width is None:
        fill = Hole((*fill.reasons, *hole_from(machine, f"str.{name}", *args).reasons))
    if name == "ljust":
        return make((*parts, fill))
    if name == "center":
        return make((fill, *parts, fill))
    if name == "zfill":  # the filling comes behind a sign
        for number, part in enumerate(parts):
            if isinstance(part, str):
                sign = 1 if part[:1] in ("+", "-") else 0
                return make(
                    (
                        *parts[:number],
                        *((part[:1],) if number == 0 and sign else ()),
                        fill,
                        part[sign:],
                        *parts[number + 1 :],
                    )
                )
    return make((fill, *parts))


def _tabs(_machine: Machine, _name: str, parts: Parts, _args: Arguments) -> Value | None:
    return make(parts) if not any(isinstance(p, str) and "\t" in p for p in parts) else None


def _every(_machine: Machine, name: str, parts: Parts, _args: Arguments) -> Value | None:
    """A question that each character must answer with yes."""
    test: Callable[[str], bool] = getattr(str, name)
    return FALSE if any(isinstance(p, str) and not test(p) for p in parts) else None


def _join(call: NativeCall) -> Value:
    """separator.join(items)."""
    machine = call.machine

    def one(separator: Value, iterable: Value) -> Value:
        orders = each_order(machine, iterable)
        if orders is None:
            return machine.unknown(Cause.RANDOM, "order of a set", "str")
        return join_all(put_together(separator, *order) for order in orders)

    def put_together(separator: Value, known: tuple[Value, ...], rest: Value | None) -> Value:
        pieces: list[Value] = []
        for item in (text_data(machine, each) for each in known):
            if isinstance(item, Const) and not isinstance(item.value, str):
                raise Raised(
                    "TypeError", f"sequence item: expected str instance, {item.value.__class__.__name__} found"
                )
            pieces.extend((separator, item) if pieces else (item,))
        if rest is not None:
            hole = hole_from(machine, "str.join", rest)
            pieces.append(Unknown(hole.reasons, "str"))
        return with_origins(joined(machine, pieces), origins(separator) if len(pieces) > 1 else frozenset())

    return spread(one, *call.args[:2])


def _join_bytes(call: NativeCall) -> Value:
    """separator.join(items), of bytes."""
    machine = call.machine

    def one(separator: Value, iterable: Value) -> Value:
        items = machine.iterate(iterable)
        pieces = [piece.value for piece in (separator, *items.known) if isinstance(piece, Const)]
        known = [piece for piece in pieces if isinstance(piece, bytes)]
        if items.rest is not None or len(known) <= len(items.known):
            return unknown_from(machine, call.name, "bytes", separator, *all_of(items))
        return Const(known[0].join(known[1:]), origins(separator, *items.known))

    return spread(one, *call.args[:2])


_Handler = Callable[[Machine, str, Parts, Arguments], Value | None]
_HANDLERS: Final[dict[str, _Handler]] = {
    **dict.fromkeys(("upper", "lower", "title", "capitalize", "swapcase", "casefold"), _case),
    **dict.fromkeys(("strip", "lstrip", "rstrip"), _strip),
    **dict.fromkeys(("removeprefix", "removesuffix"), _remove),
    **dict.fromkeys(("split", "rsplit"), _split),
    **dict.fromkeys(("partition", "rpartition"), _partition),
    **dict.fromkeys(("startswith", "endswith"), _starts),
    **dict.fromkeys(("zfill", "ljust", "rjust", "center"), _pad),
    **dict.fromkeys(_EVERY_CHARACTER, _every),
    "replace": _replace,
    "expandtabs": _tabs,
}

NATIVES: Final[dict[str, NativeFunction]] = {
    **{f"str.{name}": native(_method, _LEAST.get(name, 1)) for name in _HINTS},
    **{f"bytes.{name}": native(_method, _LEAST.get(name, 1)) for name in _BYTES},
    **FORMAT_NATIVES,
    "str.join": native(_join, 2),
    "bytes.join": native(_join_bytes, 2),
    **TRANSLATE_NATIVES,
}
