# SPDX-License-Identifier: Apache-2.0
"""Objects of `launch.actions` and `launch_ros.actions`, as actions of the tree.

LaunchDescription([Node(package='demo', executable='talker'), timer if late else node])
->  StartNode(package=(Const('demo'),), …), Maybe((Timer(…), StartNode(…)))
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, Final, final

from rosward.deployment.python.events import event_of
from rosward.deployment.python.inert import INERT, NOT_READ
from rosward.deployment.python.nodes import Nodes
from rosward.deployment.python.objects import Objects, SequenceItem, why_unknown
from rosward.deployment.python.parameters import ParameterReader
from rosward.deployment.python.substitutions import Texts
from rosward.deployment.tree import (
    Added,
    Declare,
    Environ,
    ForEach,
    Group,
    Include,
    Inert,
    LaunchAction,
    Maybe,
    OnEvent,
    Opaque,
    PushNamespace,
    ScopeChange,
    SetConfiguration,
    SetParameter,
    SetRemap,
    Timer,
    Unread,
)
from rosward.domain.choice import join_all, options
from rosward.domain.compound import External, Tuple
from rosward.domain.values import NONE, Class, Const, Ref, Value
from rosward.location import Place

_DESCRIPTION: Final = "launch.launch_description.LaunchDescription"
_UNCHANGED: Final = "launch.action.Unchanged"
_SOURCE: Final = "launch.launch_description_source.LaunchDescriptionSource"
_FORMATS: Final = {"Python": "python", "XML": "xml", "YAML": "yaml"}
_NO_ENTITIES: Final = ("launch.events.", "launch_ros.events.", "launch.substitutions.", "launch_ros.substitutions.")
"""What launch and its relatives have beside actions, and cannot execute."""
_DEEPEST: Final = 60
_MOST: Final = 10_000

Given = dict[str, Any]
"""What all actions have in common: `place`, `condition`, `identity` and `several`."""


@final
class Actions:
    """Reads lists of entities."""

    def __init__(self, objects: Objects) -> None:
        self.objects = objects
        self.texts = Texts(objects)
        self.parameters = ParameterReader(objects, self.texts)
        self._nodes = Nodes(objects, self.texts, self.parameters, self.entities)
        self.readers: dict[str, Callable[[Ref, Given], tuple[LaunchAction, ...]]] = {
            "launch_ros.actions.Node": self._node,
            "launch_ros.actions.LifecycleNode": self._node,
            "launch_ros.actions.ComposableNodeContainer": self._node,
            "launch_ros.actions.LoadComposableNodes": lambda r, g: (self._nodes.load(r, g),),
            "launch.actions.ExecuteProcess": lambda r, g: (self._nodes.process(r, g),),
            "launch.actions.ExecuteLocal": lambda r, g: (self._nodes.process(r, g),),
            "launch.actions.DeclareLaunchArgument": self._declare,
            "launch.actions.SetLaunchConfiguration": self._set_configuration,
            "launch.actions.UnsetLaunchConfiguration": self._set_configuration,
            **{f"launch.actions.{verb}EnvironmentVariable": self._environ for verb in ("Set", "Unset", "Append")},
            **{f"launch.actions.{verb}LaunchConfigurations": self._scope for verb in ("Push", "Pop", "Reset")},
            **{f"launch.actions.{verb}Environment": self._scope for verb in ("Push", "Pop", "Reset")},
            "launch.actions.GroupAction": self._group,
            "launch.actions.IncludeLaunchDescription": self._include,
            "launch.actions.OpaqueFunction": self._opaque,
            "launch.actions.OpaqueCoroutine": self._opaque,
            "launch.actions.RegisterEventHandler": self._on_event,
            "launch.actions.TimerAction": self._timer,
            "launch_ros.actions.ROSTimer": self._timer,
            "launch.actions.ForEach": self._for_each,
            "launch.actions.ForLoop": self._for_each,
            "launch_ros.actions.PushROSNamespace": self._push_namespace,
            "launch_ros.actions.SetRemap": self._set_remap,
            "launch_ros.actions.SetParameter": self._set_parameter,
            "launch_ros.actions.SetParametersFromFile": self._set_parameter,
        }
        self._descriptions: dict[Ref, set[Value]] = {}  # the launch descriptions that were read, with their entities
        self._functions = 0  # how many functions that launch calls were read
        self._open: list[Ref] = []
        self._count = 0  # how many objects were read since the outermost of them

    def entities(self, value: Value | None, place: Place) -> tuple[LaunchAction, ...]:
        """The actions in a list of entities (or one entity); `place` is that of what the list belongs to."""
        if value is None or value == NONE:
            return ()
        found: list[LaunchAction] = []
        for element in self.objects.elements(value):
            found += self._element(element, place)
        return _together(found)

    def one_of(self, descriptions: Iterable[Value], place: Place) -> tuple[LaunchAction, ...]:
        """The actions of one of several launch descriptions: what all have in common is surely there."""
        refs = [d for d in descriptions if isinstance(d, Ref)]
        return self._described(refs, join_all(self.objects.machine.load_attr(d, "entities") for d in refs), place)

    def _described(self, descriptions: Iterable[Ref], entities: Value, place: Place) -> tuple[LaunchAction, ...]:
        """The actions of launch descriptions, behind them what functions among them add."""
        for description in descriptions:
            self._unread(description)
        before = self._functions
        found = self.entities(entities, place)
        if self._functions == before:
            return found
        return (*found, *(Added(place=place, description=d) for d in descriptions))

    def appended(self, place: Place) -> dict[Value, tuple[LaunchAction, ...]]:
        """What was added to each launch description since it was read: launch, which goes through the list, comes to it."""
        found: dict[Value, tuple[LaunchAction, ...]] = {}
        for description in list(self._descriptions):
            added = [a for element in self._unread(description) for a in self._element(element, place)]
            if added:
                found[description] = _together(added)
        return found

    def _unread(self, description: Ref) -> list[SequenceItem]:
        """The entities of a launch description that were not read yet."""
        objects = self.objects
        read = self._descriptions.setdefault(description, set())
        found: list[SequenceItem] = []
        for element in objects.elements(objects.machine.load_attr(description, "entities")):
            values = options(element.value)
            fresh = [value for value in values if value not in read]
            read.update(fresh)
            if fresh:
                found.append(SequenceItem(join_all(fresh), element.sure and len(fresh) == len(values)))
        return found

    def _element(self, element: SequenceItem, place: Place) -> tuple[LaunchAction, ...]:
        found = options(element.value)
        read = tuple(a for o in found for a in self._one(o, place))
        if element.sure and len(found) == 1:
            return read
        if not read:
            return ()
        if all(isinstance(a, Unread) for a in read):
            return read
        return (Maybe(place=read[0].place, actions=read, why=why_unknown(found) or "unknown condition in Python"),)

    def _one(self, value: Value, place: Place) -> tuple[LaunchAction, ...]:
        """One entity."""
        if value == NONE:
            return ()
        if not isinstance(value, Ref):
            if isinstance(value, Tuple):
                return self.entities(value, place)
            if isinstance(value, Const):
                self.objects.tell("RW320", f"{value.value!r} is not a launch entity", place)
                return ()
            why = why_unknown((value,)) or (value.name if isinstance(value, External) else "not a launch entity")
            return (Unread(place=_where(value, place), why=why),)
        if not self._open:
            self._count = 0
        self._count += 1
        if value in self._open or len(self._open) > _DEEPEST:
            return (Unread(place=place, why="a launch description that contains itself"),)
        if self._count > _MOST:
            return (Unread(place=place, why=f"more than {_MOST} entities"),)
        self._open.append(value)
        try:
            return self._of_object(value, place)
        finally:
            self._open.pop()

    def _of_object(self, ref: Ref, place: Place) -> tuple[LaunchAction, ...]:
        objects = self.objects
        if objects.is_sequence(ref):
            return self.entities(ref, place)
        kind = objects.kind(ref)
        made = objects.place(ref)
        here = made if made.file else place
        if kind == _DESCRIPTION:
            return self._described((ref,), objects.machine.load_attr(ref, "entities"), here)
        if kind == _UNCHANGED:
            inner = objects.field(ref, "action")
            return self._as_modelled(inner, here) if isinstance(inner, Ref) else ()
        for method in ("execute", "visit"):
            if kind and objects.overrides(ref, method):
                condition = self.texts.condition(objects.field(ref, "condition"), here)
                function = objects.machine.load_attr(ref, method)
                self._functions += 1
                return (Opaque(place=here, condition=condition, identity=ref, function=function),)
        return self._as_modelled(ref, here)

    def _as_modelled(self, ref: Ref, here: Place) -> tuple[LaunchAction, ...]:
        """An action as the library's own class executes it."""
        objects = self.objects
        kind = objects.kind(ref)
        condition = self.texts.condition(objects.field(ref, "condition"), here)
        given: Given = {
            "place": here,
            "condition": condition,
            "identity": ref,
            "several": objects.machine.obj(ref).many,
        }
        for each in objects.kinds(ref):  # an action that derives from another one is executed as that one is
            reader = self.readers.get(each)
            if reader is not None:
                return reader(ref, given)
            if each in INERT:
                return (Inert(kind=kind.rpartition(".")[2], **given),)
            if each in NOT_READ:
                return (Unread(place=here, why=f"{kind.rpartition('.')[2]} is not analysed: {NOT_READ[each]}"),)
        cls = objects.machine.obj(ref).cls
        name = cls.name if isinstance(cls, (Class, External)) else objects.machine.obj(ref).kind
        if kind.startswith(_NO_ENTITIES):
            objects.tell("RW320", f"{kind} is not a launch entity: it starts nothing, and launch fails here", here)
            return ()
        return (Unread(place=here, why=f"{name} is not a known launch entity"),)

    def _read_as(self, ref: Ref) -> str:
        """The last part of the name of the class by which an action is read."""
        return next(k for k in self.objects.kinds(ref) if k in self.readers).rpartition(".")[2]

    # One method a class

    def _node(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        return (self._nodes.node(ref, given),)

    def _declare(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        place = given["place"]
        choices = self.objects.field(ref, "choices")
        return (
            Declare(
                name=self.texts.template(self.objects.field(ref, "name"), place),
                default=self.texts.optional(self.objects.field(ref, "default"), place),
                choices=None if choices is None else self.texts.words(choices, place),
                description=self.texts.template(self.objects.field(ref, "description"), place),
                **given,
            ),
        )

    def _set_configuration(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        place = given["place"]
        value = self.texts.optional(self.objects.field(ref, "value"), place)
        return (
            SetConfiguration(name=self.texts.template(self.objects.field(ref, "name"), place), value=value, **given),
        )

    def _environ(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        place = given["place"]
        how = {"S": "set", "U": "unset", "A": "append"}[self._read_as(ref)[0]]
        if how == "append" and self.objects.flag(ref, "prepend", False):
            how = "prepend"
        return (
            Environ(
                how=how,
                name=self.texts.template(self.objects.field(ref, "name"), place),
                value=self.texts.template(self.objects.field(ref, "value"), place),
                separator=self.texts.template(self.objects.field(ref, "separator"), place),
                **given,
            ),
        )

    def _scope(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        name = self._read_as(ref)
        how = "push" if name.startswith("Push") else "pop" if name.startswith("Pop") else "reset"
        what = "environment" if name.endswith("Environment") else "configurations"
        pairs = self.texts.pairs(self.objects.field(ref, "configurations"), given["place"])
        return (ScopeChange(what=what, how=how, configurations=pairs, **given),)

    def _group(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        place = given["place"]
        return (
            Group(
                actions=self.entities(self.objects.field(ref, "actions"), place),
                scoped=self.objects.flag(ref, "scoped", True),
                forwarding=self.objects.flag(ref, "forwarding", True),
                configurations=self.texts.pairs(self.objects.field(ref, "configurations"), place),
                **given,
            ),
        )

    def _include(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        place = given["place"]
        arguments = self.texts.pairs(self.objects.field(ref, "arguments"), place)
        source = self.objects.field(ref, "source")
        found = tuple(self._included(o, arguments, given) for o in options(source or NONE))
        return found if len(found) == 1 else (Maybe(place=place, actions=found, why="one of several launch files"),)

    def _included(self, source: Value, arguments: tuple[Any, ...], given: Given) -> LaunchAction:
        place = given["place"]
        if self.objects.is_a(source, _DESCRIPTION):
            return Include(path=None, arguments=arguments, body=self.entities(source, place), **given)
        if not isinstance(source, Ref) or not self.objects.is_a(source, _SOURCE):
            return Include(path=self.texts.template(source, place), arguments=arguments, **given)
        description = self.objects.field(source, "description")
        if description is not None:
            return Include(path=None, arguments=arguments, body=self.entities(description, place), **given)
        name = self.objects.kind(source).rpartition(".")[2]
        form = next((f for begin, f in _FORMATS.items() if name.startswith(begin)), "any")
        path = self.texts.template(self.objects.field(source, "location"), place)
        loader = None if self.objects.machine.obj(source).many else source
        return Include(path=path, format=form, arguments=arguments, loader=loader, **given)

    def _opaque(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        function, place = self.objects.field(ref, "function"), given["place"]
        if function is None:
            return (Unread(place=place, why="OpaqueFunction without a function"),)
        elements = self.objects.elements(self.objects.field(ref, "args") or NONE)
        args = tuple(e.value if e.sure else self.objects.perhaps(e.value, place) for e in elements)
        kwargs = self.objects.field(ref, "kwargs")
        self._functions += 1
        named: list[tuple[str, Value]] = []
        if isinstance(kwargs, Ref) and self.objects.is_dict(kwargs):
            obj = self.objects.machine.obj(kwargs)
            entries = [(k, self.objects.perhaps(v, place) if k in obj.maybe else v) for k, v in obj.entries.items()]
            named = [(str(k.value), v) for k, v in entries if isinstance(k, Const)]
        return (Opaque(function=function, args=args, kwargs=tuple(named), **given),)

    def _on_event(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        handler = self.objects.field(ref, "event_handler") or NONE
        found: list[LaunchAction] = []
        for option in options(handler):
            if not isinstance(option, Ref):
                found.append(Unread(place=given["place"], why=why_unknown((option,)) or "unknown event handler"))
                continue
            event, value = event_of(self.objects, option)
            target = self.objects.field(option, "target")
            place = self.objects.place(option)
            actions, functions = self._reaction(value, place if place.file else given["place"])
            for function in functions or (None,):
                found.append(OnEvent(event=event, actions=actions, function=function, target=target, **given))
        return tuple(found)

    def _reaction(self, value: Value, place: Place) -> tuple[tuple[LaunchAction, ...], tuple[Value, ...]]:
        """What a handler does: actions, and functions that give more."""
        elements = self.objects.elements(value)
        functions = tuple(e.value for e in elements if self.objects.is_callable(e.value))
        others = [e for e in elements if not self.objects.is_callable(e.value)]
        return _together([a for e in others for a in self._element(e, place)]), functions

    def _timer(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        period = self.objects.field(ref, "period")
        text = (period,) if isinstance(period, Const) else self.texts.template(period, given["place"])
        actions = self.entities(self.objects.field(ref, "actions"), given["place"])
        return (Timer(period=text, actions=actions, **given),)

    def _for_each(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        values = self.objects.field(ref, "values")
        text = (values,) if isinstance(values, Const) else self.texts.template(values, given["place"])
        name = self.objects.field(ref, "name")
        count = self._read_as(ref) == "ForLoop"
        index = str(name.value) if isinstance(name, Const) else ""
        function = self.objects.field(ref, "function")
        return (ForEach(values=text, count=count, function=function, index_name=index, **given),)

    def _push_namespace(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        return (
            PushNamespace(namespace=self.texts.template(self.objects.field(ref, "namespace"), given["place"]), **given),
        )

    def _set_remap(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        source = self.texts.template(self.objects.field(ref, "source"), given["place"])
        target = self.texts.template(self.objects.field(ref, "target"), given["place"])
        return (SetRemap(source=source, target=target, **given),)

    def _set_parameter(self, ref: Ref, given: Given) -> tuple[LaunchAction, ...]:
        place = given["place"]
        if self._read_as(ref).endswith("FromFile"):
            for source in self.parameters.sources(Tuple((self.objects.field(ref, "path") or NONE,)), place):
                return (SetParameter(parameter=source, **given),)
            return ()
        name = self.texts.template(self.objects.field(ref, "name"), place)
        sources = self.parameters.named(name, self.objects.field(ref, "value") or NONE, place)
        return tuple(SetParameter(parameter=source, **given) for source in sources)


def _where(value: Value, place: Place) -> Place:
    """Where an unknown value arose, if that is in a file."""
    reasons = getattr(value, "reasons", ())
    return next((r.place for r in reasons if r.place.file), place)


def _together(actions: list[LaunchAction]) -> tuple[LaunchAction, ...]:
    """Neighbours that are Maybe for the same reason, as one."""
    found: list[LaunchAction] = []
    for action in actions:
        last = found[-1] if found else None
        if isinstance(action, Maybe) and isinstance(last, Maybe) and action.why == last.why:
            found[-1] = Maybe(place=last.place, actions=(*last.actions, *action.actions), why=last.why)
        else:
            found.append(action)
    return tuple(found)
