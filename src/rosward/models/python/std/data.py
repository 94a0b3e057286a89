# SPDX-License-Identifier: Apache-2.0
"""Data that stands in the program as text, and data in files: `json`, `yaml`, `tomllib`.

json.loads('{"topic": "/scan"}')          a dict with 'topic': '/scan'
yaml.safe_load(open(share + '/a.yaml'))   what is in the file, if it is one of the analysed packages
yaml.safe_load(open('/etc/a.yaml'))       unknown because of "content of a file: /etc/a.yaml"
"""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Final

import yaml

from rosward.domain.choice import join_all, lift, options, reasons_of
from rosward.domain.text import origins_of, readable
from rosward.domain.unknown import Cause
from rosward.domain.values import NONE, UNBOUND, Class, Const, Ref, Text, Unknown, Value
from rosward.models.native import NativeCall, NativeFunction
from rosward.models.python.plain import text_of
from rosward.models.python.std.support import MAX_DEPTH, NotKnown, from_plain, to_plain, unknown_from
from rosward.source.toml import read_toml

MAX_TEXT: Final = 1_000_000
_MAX_ALIASES: Final = 100
_MAX_MERGED: Final = 12  # aliases, where mappings are merged: each may double what there is
_MAX_EVENTS: Final = 50_000
_LOADER: Final = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def _json(text: str) -> object:
    return json.loads(text)


def _yaml(text: str) -> object:
    try:
        _bound(text)
        return yaml.load(text, Loader=_LOADER)
    except yaml.constructor.ConstructorError as error:  # a tag: a loader of the program may know it
        raise NotKnown from error
    except yaml.YAMLError as error:
        raise ValueError(str(error).partition("\n")[0]) from error


def _toml(text: str) -> object:
    return read_toml(text)


def _bound(text: str) -> None:
    """Raises NotKnown for what is too large, too deep, or grows with its aliases."""
    depth = aliases = 0
    most = _MAX_MERGED if "<<" in text else _MAX_ALIASES
    for number, event in enumerate(yaml.parse(text, Loader=_LOADER)):
        depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
        aliases += isinstance(event, yaml.AliasEvent)
        if number > _MAX_EVENTS or depth > MAX_DEPTH or aliases > most:
            raise NotKnown


def _read(parse: Callable[[str], object], call: NativeCall, source: Value) -> Value:
    """The data in a text; of a file, nothing is known but which."""

    def one(option: Value) -> Value:
        plain = (
            option.value.decode("utf-8", "replace")
            if isinstance(option, Const) and isinstance(option.value, bytes)
            else text_of(option)
        )
        if plain is None:
            return _of_file(call, option)
        if len(plain) > MAX_TEXT:
            return call.machine.unknown(Cause.LIMIT, f"{call.name} of a long text")
        try:
            return from_plain(call.machine, parse(plain), origins_of(option))
        except NotKnown:
            return call.machine.unknown(Cause.LIMIT, call.name)
        except (ValueError, TypeError, AttributeError) as error:
            kind = "JSONDecodeError" if call.name.startswith("json") else "YAMLError"
            return call.machine.die(kind, f"{call.name}: {error}")
        except RecursionError:
            return call.machine.unknown(Cause.LIMIT, f"nesting in {call.name}")

    return lift(one, _left_in(call, source))


def _left_in(call: NativeCall, source: Value) -> Value:
    """What is still to be read, and then no longer is, of files of the sources that `open` gave (stubs/_opened.pyi); any other value itself."""
    machine = call.machine
    files = [o for o in options(source) if isinstance(o, Ref) and "_ahead" in machine.obj(o).attrs]
    if not files:
        return source
    others = (o for o in options(source) if o not in files)
    return join_all((machine.call(machine.load_attr(join_all(files), "read"), ()), *others))


def _of_file(call: NativeCall, source: Value) -> Value:
    if isinstance(source, Unknown) and reasons_of(source):
        return Unknown(source.reasons)
    if isinstance(source, Text):
        return unknown_from(call, "", (source,))
    name = ""
    if isinstance(source, Ref):
        where = call.machine.obj(source).attrs.get("name")
        name = readable(where) if where is not None else ""
    return call.machine.unknown(Cause.FILE, "" if name == "*" else name)


def _reader(parse: Callable[[str], object], name: str) -> NativeFunction:
    def read(call: NativeCall) -> Value:
        source = call.arg(0, name)
        if source is None:
            return call.machine.die("TypeError", f"{call.name}() missing 1 required positional argument: '{name}'")
        if _hooked(call):
            return unknown_from(call, "", (source,))
        loader = call.arg(1, "Loader") if call.name in ("yaml.load", "yaml.load_all") else None
        if isinstance(loader, Class) and loader.name == "BaseLoader":  # it leaves every scalar a text
            return unknown_from(call, "", (source,))
        return _read(parse, call, source)

    return read


def _all_yaml(text: str) -> object:
    try:
        _bound(text)
        return list(yaml.load_all(text, Loader=_LOADER))
    except yaml.constructor.ConstructorError as error:
        raise NotKnown from error
    except yaml.YAMLError as error:
        raise ValueError(str(error).partition("\n")[0]) from error


def _all_documents(call: NativeCall) -> Value:
    """yaml.load_all: a list of what is in each document."""
    found = _reader(_all_yaml, "stream")(call)
    if found is UNBOUND:
        return found
    return join_all(
        option if isinstance(option, Ref) else call.machine.new_list((), option) for option in options(found)
    )


_HOOKS: Final = ("default", "cls", "object_hook", "object_pairs_hook", "parse_float", "parse_int", "parse_constant")


def _hooked(call: NativeCall) -> bool:
    """Whether functions or classes of the program are given that take part: they are called."""
    hooks = [v for k, v in call.keywords.items() if k in _HOOKS and v != NONE]
    call.machine.escape(hooks, call.name)
    return bool(hooks)


def _dumps(call: NativeCall) -> Value:
    """json.dumps of what is known; else an unknown text."""
    if _hooked(call):
        return unknown_from(call, "str", call.args)
    try:
        value, origins = to_plain(call.machine, call.args[0])
        options = {k: to_plain(call.machine, v)[0] for k, v in call.keywords.items()}
        if len(call.args) > 1 or not options.keys() <= {"indent", "sort_keys", "ensure_ascii", "separators"}:
            raise NotKnown
        dump: Callable[..., str] = json.dumps
        return Const(dump(value, **options), origins)
    except NotKnown:
        return unknown_from(call, "str", call.args)
    except (IndexError, TypeError, ValueError, RecursionError) as error:
        return call.machine.die("TypeError", f"{call.name}: {error}")


_WAYS: Final = frozenset({"allow_unicode", "default_flow_style", "indent", "sort_keys", "width"})
"""What says how YAML is written, and takes plain values."""


def _dumped(call: NativeCall) -> Value:
    """`yaml._dumped(data, options)`: the text that yaml.dump makes of what is known; else an unknown one."""
    try:
        value, origins = to_plain(call.machine, call.args[0])
        given, others = to_plain(call.machine, call.args[1])
        if not isinstance(given, dict) or not given.keys() <= _WAYS or _has_tuple(value):
            raise NotKnown
        return Const(yaml.safe_dump(value, **given), origins | others)
    except (NotKnown, TypeError, ValueError, yaml.YAMLError, RecursionError):
        return unknown_from(call, "str", call.args)


def _has_tuple(value: object) -> bool:
    """Whether there is a tuple in it, which yaml.dump and yaml.safe_dump write in different ways."""
    if isinstance(value, dict):
        return any(_has_tuple(each) for pair in value.items() for each in pair)
    return isinstance(value, tuple) or (isinstance(value, list) and any(map(_has_tuple, value)))


NATIVES: Final[dict[str, NativeFunction]] = {
    "json.loads": _reader(_json, "s"),
    "json.load": _reader(_json, "fp"),
    "json.dumps": _dumps,
    "tomllib.loads": _reader(_toml, "s"),
    "tomllib.load": _reader(_toml, "fp"),
    "simplejson.loads": _reader(_json, "s"),
    "simplejson.load": _reader(_json, "fp"),
    "yaml.safe_load": _reader(_yaml, "stream"),
    "yaml.load": _reader(_yaml, "stream"),
    "yaml.full_load": _reader(_yaml, "stream"),
    "yaml.unsafe_load": _reader(_yaml, "stream"),
    "yaml.safe_load_all": _all_documents,
    "yaml.load_all": _all_documents,
    "yaml._dumped": _dumped,
}
