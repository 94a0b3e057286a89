# SPDX-License-Identifier: Apache-2.0
"""The module `_rosward.launch` that the models of launch import: objects that keep what they are given, and questions to the launch.

Node(package='demo', executable='talker')   the object keeps `launch.package`, `launch.executable` and the place of this call
context.launch_configurations['robot']      the value that the launch has now, where one is going on
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final, final

from rosward.domain.certain import text_of
from rosward.domain.choice import join, join_all, lift, options
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.text import readable
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import FALSE, NONE, TRUE, Class, Const, Ref, Unknown, Value
from rosward.location import Place
from rosward.models.native import Arguments, Machine, NativeCall, NativeFunction
from rosward.models.python.std.paths import as_text

if TYPE_CHECKING:
    from rosward.effects.launch_context import LaunchContext

FIELD: Final = "launch."
"""How the attributes begin in which an object keeps what it was given: no program can name them."""

PLACE: Final = FIELD + "place"
REQUIRED: Final = External("_rosward.launch.REQUIRED")
_LIVE: Final = frozenset({"actions", "composable_node_descriptions", "event_handler", "function", "on_exit"})
"""What launch keeps as it is; everything else it copies, so that later changes of a list do not count."""

_OLD: Final = {
    "node_executable": "executable",
    "node_name": "name",
    "node_namespace": "namespace",
    "node_plugin": "plugin",
}
"""Keywords of early releases, which raise TypeError now."""

_DEEPEST: Final = 6
_MOST: Final = 5_000


# Objects


def _keep(call: NativeCall) -> Value:
    """keep(self, kwargs, name=value, …): at the end of the chain of classes, `kwargs` are the keywords that none of them takes."""
    machine = call.machine
    place = machine.place
    fields = dict(call.keywords)
    for ref in options(call.args[0]):
        if not isinstance(ref, Ref) or machine.obj(ref).kind != "instance":
            continue
        obj = machine.obj(ref)
        copier = _Copier(machine)
        kept = {FIELD + n: v if n in _LIVE else copier.copy(v, (n,)) for n, v in fields.items()}
        attrs = {**obj.attrs, **kept, PLACE: Tuple((Const(place.file), Const(place.line), Const(place.column)))}
        if len(call.args) > 1 and isinstance(call.args[1], Ref):
            attrs = _checked(machine, obj, attrs, call.args[1])
        machine.update(ref, obj.replace(attrs=attrs))
    return NONE


def _class_name(obj: Obj) -> str:
    return obj.cls.name if isinstance(obj.cls, (Class, External)) else "object"


def _checked(machine: Machine, obj: Obj, attrs: dict[str, Value], kwargs: Ref) -> dict[str, Value]:
    """What an object keeps, with keywords that nothing takes: a mistake, and those of early releases still say what was meant."""
    given = {text_of(key): value for key, value in machine.obj(kwargs).entries.items()}
    missing = [n.removeprefix(FIELD) for n, v in attrs.items() if v == REQUIRED]
    if given:
        names = ", ".join(f"'{name}'" for name in given)
        machine.report("RW320", f"{_class_name(obj)}() got unexpected keyword arguments: {names}")
    elif missing and machine.obj(kwargs).rest is None:
        names = ", ".join(f"'{name}'" for name in missing)
        machine.report("RW320", f"{_class_name(obj)}() misses the arguments {names}")
    return {**attrs, **{FIELD + _OLD[name]: value for name, value in given.items() if name in _OLD}}


@final
class _Copier:
    """Copies a value as it is now, with all lists and dicts in it, up to a number of elements: what is beyond it is shared."""

    def __init__(self, machine: Machine) -> None:
        self._machine = machine
        self._left = _MOST

    def copy(self, value: Value, path: tuple[object, ...]) -> Value:
        self._left -= 1
        if len(path) > _DEEPEST or self._left < 0:
            return value
        if isinstance(value, Tuple):
            return Tuple(tuple(self.copy(v, (*path, n)) for n, v in enumerate(value.items)))
        if isinstance(value, Ref):
            return self._object(value, path)
        found = options(value)
        return value if len(found) == 1 else join_all(self.copy(v, (*path, n)) for n, v in enumerate(found))

    def _object(self, ref: Ref, path: tuple[object, ...]) -> Value:
        machine, site = self._machine, ("copy", path)
        obj = machine.obj(ref)
        if obj.kind in ("list", "set") and obj.items is None:
            return machine.allocate(obj.replace(kind="list", many=False), site)
        if obj.kind in ("list", "set", "generator"):
            known, rest = machine.iterate(ref)
            items = tuple(self.copy(v, (*path, n)) for n, v in enumerate(known))
            return machine.allocate(_listed(items, rest), site)
        if obj.kind == "dict":
            entries = {k: self.copy(v, (*path, n)) for n, (k, v) in enumerate(obj.entries.items())}
            return machine.allocate(obj.replace(entries=entries, many=False), site)
        return ref


def _listed(items: tuple[Value, ...], rest: Value | None) -> Obj:
    if rest is None:
        return Obj("list", Native("builtins.list"), items=items)
    return Obj("list", Native("builtins.list"), items=None, rest=join_all([*items, rest]))


def place_of(obj: Obj) -> Place:
    """Where an object was made."""
    found = options(obj.attrs.get(PLACE, NONE))[0]
    if isinstance(found, Tuple):
        file, line, column = (i.value if isinstance(i, Const) else 0 for i in found.items)
        return Place(str(file), *(number if isinstance(number, int) else 0 for number in (line, column)))
    return Place("", 0)


# Questions to the launch


def _launch(call: NativeCall) -> LaunchContext | None:
    """The launch that is going on. Its answers may be others next time, so no call that asks is remembered."""
    machine = call.machine
    launch = machine.log.launch
    if launch is not None:
        machine.state.version = machine.fresh_version()
    return launch


def _perform(call: NativeCall) -> Value:
    launch = _launch(call)
    if launch is None:
        return call.machine.unknown(Cause.ARGUMENT, "launch", "str")
    return launch.perform(call.args[0])


def _evaluate(call: NativeCall) -> Value:
    launch = _launch(call)
    if launch is None:
        return call.machine.unknown(Cause.ARGUMENT, "launch", "bool")
    return launch.evaluate(call.args[0])


def _not_known(call: NativeCall, name: Value, hint: str = "str") -> Unknown:
    return call.machine.unknown(Cause.ARGUMENT, readable(name), hint)


def _configuration(call: NativeCall) -> Value:
    """launch_configurations[name], or with a default."""
    launch = _launch(call)

    def one(name: Value) -> Value:
        if launch is None:
            return _not_known(call, name)
        if not isinstance(name, Const):
            every = [v for k, v in launch.configurations().items()]
            return join_all([*every, *call.args[1:2], _not_known(call, name)])
        found = launch.configuration(text_of(name))
        if found is not None:
            return found
        if len(call.args) > 1:
            return call.args[1]
        if not call.machine.is_tried:
            call.machine.report("RW320", f"the launch configuration '{text_of(name)}' is not set")
        return call.machine.die("KeyError", text_of(name))

    return lift(one, call.args[0])


def _has_configuration(call: NativeCall) -> Value:
    launch = _launch(call)

    def one(name: Value) -> Value:
        if launch is None or not isinstance(name, Const):
            return _not_known(call, name, "bool")
        return FALSE if launch.configuration(text_of(name)) is None else TRUE

    return lift(one, call.args[0])


def _configurations(call: NativeCall) -> Value:
    """A dict of them all."""
    launch = _launch(call)
    if launch is None:
        return call.machine.unknown(Cause.ARGUMENT, "launch_configurations", "dict")
    return call.machine.new_dict({Const(k): v for k, v in launch.configurations().items()})


def _set_configuration(call: NativeCall) -> Value:
    """launch_configurations[name] = value; a value of None removes it. On a way that need not be taken the old value stays possible."""
    launch = _launch(call)
    if launch is not None:
        _assign(call, launch.configuration, launch.set_configuration)
    return NONE


def _set_listed(call: NativeCall) -> Value:
    """set_configuration(name, items) of one that is a list of pairs or texts: the launch does not see the program's objects."""
    name, value = call.exactly(2)
    return _set_configuration(call._replace(args=Arguments((name, _without_objects(call.machine, value)))))


def _rewrite_configuration(call: NativeCall) -> Value:
    """All items of a launch configuration that is a list, which has changed in place. Where it need not have, the old ones stay possible."""
    launch = _launch(call)
    if launch is not None:
        name, value = call.exactly(2)
        listed, old = _without_objects(call.machine, value), launch.configuration(text_of(name))
        launch.rewrite_configuration(
            text_of(name), listed if call.machine.is_sure or old is None else join(old, listed)
        )
    return NONE


def _add_to_configuration(call: NativeCall) -> Value:
    """An item more in a launch configuration that is a list. On a way that need not be taken, one that may be any is added."""
    launch = _launch(call)
    if launch is not None:
        name, value = call.exactly(2)
        sure = call.machine.is_sure
        item = _without_objects(call.machine, value) if sure else _not_known(call, name)
        launch.add_to_configuration(text_of(name), item)
    return NONE


def _without_objects(machine: Machine, value: Value) -> Value:
    """A list with all that is in it as a value; unknown where not all is known."""
    if isinstance(value, Ref) and machine.obj(value).kind in ("list", "dict"):
        known, rest = machine.iterate(value)
        value = machine.unknown(Cause.ARGUMENT, "list") if rest is not None else Tuple(tuple(known))
    return Tuple(tuple(_without_objects(machine, v) for v in value.items)) if isinstance(value, Tuple) else value


def _assign(call: NativeCall, read: Callable[[str], Value | None], write: Callable[[str, Value | None], None]) -> None:
    name, value = call.exactly(2)
    sure = call.machine.is_sure
    for each in options(name):
        if not isinstance(each, Const):
            continue
        old = read(text_of(each))
        if value == NONE:
            if sure:
                write(text_of(each), None)
        else:
            write(text_of(each), value if sure or old is None else join(old, value))


def _variable(call: NativeCall) -> Value:
    """The value that an environment variable has in the launch, else None."""
    launch = _launch(call)
    name = call.args[0]
    if launch is None or not isinstance(name, Const):
        return NONE
    return launch.variable(text_of(name)) or NONE


def _removed(call: NativeCall) -> Value:
    """Whether launch has removed an environment variable."""
    launch = _launch(call)
    name = call.args[0]
    return Const(launch is not None and isinstance(name, Const) and launch.removed(text_of(name)))


def _set_variable(call: NativeCall) -> Value:
    launch = _launch(call)
    if launch is not None:
        _assign(call, launch.variable, launch.set_variable)
    return NONE


def _write_file(call: NativeCall) -> Value:
    """The text that a file of a known path holds now; nobody knows it where it is not known whether this runs."""
    launch = _launch(call)
    if launch is not None:
        path, text = call.exactly(2)
        path = as_text(call, path)
        sure = call.machine.is_sure
        launch.write_file(path, text if sure else call.machine.unknown(Cause.FILE, readable(path), "str"))
    return NONE


def _replaced(call: NativeCall) -> Value:
    """`shutil.copy` and the like: the file behind the target is another one, or one in it; what it holds is not followed."""
    launch = _launch(call)
    source, target = (as_text(call, call.arg(at, name, NONE) or NONE) for at, name in enumerate(("src", "dst")))
    if launch is not None:
        unknown = call.machine.unknown(Cause.FILE, readable(target), "str")
        name = call.machine.call_native("os.path.basename", (source,))
        for path in (target, call.machine.call_native("os.path.join", (target, name))):
            launch.write_file(path, unknown)
        if call.name in ("shutil.move", "_rosward.launch.replaced"):
            launch.write_file(source, NONE if call.machine.is_sure else unknown)
    return call.machine.unknown(Cause.FILE, call.name, "str") if call.name.startswith("shutil.") else NONE


def _temporary(call: NativeCall) -> Value:
    """A path of `tempfile`: of its own for each call in a launch, unknown in any other program."""
    launch = _launch(call)
    if launch is None:
        return call.machine.unknown(Cause.RANDOM, call.name, "str")
    return Const("/tmp") if call.name.endswith("gettempdir") else launch.new_path()


def _temporary_file(call: NativeCall) -> Value:
    """NamedTemporaryFile, which is gone once it is closed unless the program says otherwise."""
    launch = _launch(call)
    if launch is None:
        return call.machine.unknown(Cause.CALL, call.name)
    opened = call.machine.load_attr(call.machine.load_module("_opened"), "TemporaryFile")
    kept = {name: value for name, value in call.keywords.items() if name in ("delete", "delete_on_close")}
    return call.machine.call(opened, (launch.new_path(),), kept)


def _folder(cause: Cause) -> NativeFunction:
    """Where a package is installed: unknown, and known to be that of the package."""

    def of(call: NativeCall) -> Value:
        def one(name: Value) -> Value:
            subject = text_of(name) or readable(name)
            return Unknown((Reason(cause, subject, call.machine.place),), "str")

        return lift(one, call.args[0])

    return of


def _is_package(call: NativeCall) -> Value:
    """Whether a package is among the sources; None where its name is not known."""

    def one(name: Value) -> Value:
        if not isinstance(name, Const):
            return NONE
        return Const(call.machine.files.is_file(text_of(name) or "", "package.xml"))

    return lift(one, call.args[0])


NATIVES: Final[dict[str, NativeFunction]] = {
    "_rosward.launch.keep": _keep,
    "_rosward.launch.perform": _perform,
    "_rosward.launch.evaluate": _evaluate,
    "_rosward.launch.configuration": _configuration,
    "_rosward.launch.has_configuration": _has_configuration,
    "_rosward.launch.configurations": _configurations,
    "_rosward.launch.set_configuration": _set_configuration,
    "_rosward.launch.set_listed": _set_listed,
    "_rosward.launch.add_to_configuration": _add_to_configuration,
    "_rosward.launch.rewrite_configuration": _rewrite_configuration,
    "_rosward.launch.variable": _variable,
    "_rosward.launch.removed": _removed,
    "_rosward.launch.set_variable": _set_variable,
    **dict.fromkeys(("tempfile.mkdtemp", "tempfile.gettempdir", "tempfile.mktemp"), _temporary),
    "tempfile.NamedTemporaryFile": _temporary_file,
    "_rosward.launch.write_file": _write_file,
    **dict.fromkeys(("shutil.copy", "shutil.copy2", "shutil.copyfile", "shutil.move"), _replaced),
    "_rosward.launch.replaced": _replaced,
    "_rosward.launch.share_folder": _folder(Cause.SHARE),
    "_rosward.launch.prefix_folder": _folder(Cause.PREFIX),
    "_rosward.launch.is_package": _is_package,
}
