# SPDX-License-Identifier: Apache-2.0
"""The walk over the actions of one launched system, in the order in which launch executes them.

group(push a; node x; timer 2 s: node y); node z     ->     x below /a, z, and then y, where the group and its namespace are gone

What is not known is executed both ways: its effects on the context are joined with the state before, what it starts is conditional.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Final, final

from rosward.deployment import tree
from rosward.deployment.execution.conditions import Truth, decide
from rosward.deployment.execution.includes import Descriptions
from rosward.deployment.execution.later import Agenda, Later
from rosward.deployment.execution.loops import Turn, turns
from rosward.deployment.execution.nodes import At, container_name, load_component, start_node
from rosward.deployment.execution.perform_paths import folder, joined, normal_path
from rosward.deployment.execution.processes import Launch, start_process
from rosward.deployment.execution.scene import Scene
from rosward.deployment.execution.settings import SETTINGS, change, performed
from rosward.deployment.execution.substitutions import SUBSTITUTIONS
from rosward.deployment.execution.yaml_values import plain_text
from rosward.deployment.started import Started
from rosward.domain.choice import options
from rosward.domain.compound import Partial
from rosward.domain.text import readable
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import Const, Unknown, Value
from rosward.guard import guarded
from rosward.location import Place
from rosward.network.launch_tree import Inclusion

MAX_INCLUDES: Final = 40
MAX_NESTING: Final = 90


@final
class LaunchBudget:
    """How many actions are executed in all, whatever includes what; and `net`, see `guard.py`."""

    def __init__(self, actions: int, *, net: bool = True) -> None:
        self.left = actions
        self.net = net


@final
class RunningLaunch:
    """One launch: its context, what it has started, and what still waits."""

    def __init__(self, scene: Scene, descriptions: Descriptions, budget: LaunchBudget) -> None:
        self.scene = scene
        self.started: list[Started] = []
        self._descriptions = descriptions
        self._budget = budget
        self._agenda = Agenda()
        self._containers: dict[tuple[Place, object, object], Value] = {}
        self._executed: set[tuple[int, Value]] = set()
        self._loads: dict[tuple[int, Value], int] = {}
        """Which load of a file it was that a source, in its own load, stands for."""
        self._added: dict[Value, list[tuple[tuple[tree.LaunchAction, ...], tuple[str, ...]]]] = {}
        """What functions have added to launch descriptions, and why it is open whether these ran."""

    def run(self, file: str, path: Value, at: At) -> None:
        """Execute a launch file, and then what waits for timers and events."""
        self.scene.context.files = (path,)
        description = self._descriptions.read(file, "any", self.scene)
        if description is not None:
            self.walk(description.actions, at)
        later = self._agenda.next()
        while later is not None:
            self._fire(later)
            later = self._agenda.next()

    # Order

    def walk(self, actions: Iterable[tree.LaunchAction], at: At) -> None:
        """Execute actions one after the other."""
        for action in actions:
            if not self._allowed(action.place, at):
                return
            self._agenda.see(action)
            verdict = decide(action.condition, self.scene)
            if verdict.true:
                self._by(verdict, partial(self._execute, action), at)
            else:
                self._agenda.see_inside(action)

    def _add(self, description: Value, at: At) -> None:
        """Execute what functions have added to a launch description, which may add more; where it is open whether they ran, perhaps."""
        while added := self._added.pop(description, None):
            for actions, why in added:
                unsure = at
                for each in why:
                    unsure = unsure.maybe(each)
                if unsure == at:
                    self.walk(actions, at)
                else:
                    saved = self.scene.context.save()
                    self.walk(actions, unsure)
                    self.scene.context.join(saved)

    def _by(self, verdict: Truth, execute: Callable[[At], None], at: At) -> None:
        """Execute, or where that is open, join the state behind with the state before."""
        if not verdict.open:
            execute(at)
            return
        saved = self.scene.context.save()
        execute(at.maybe(verdict.why))
        self.scene.context.join(saved)

    def _allowed(self, place: Place, at: At) -> bool:
        self._budget.left -= 1
        if self._budget.left > 0 and at.depth < MAX_NESTING and len(at.trail) <= MAX_INCLUDES:
            return True
        what = "includes or groups are nested too deeply" if self._budget.left > 0 else "too many actions"
        self.scene.findings.tell("RW201", f"The execution of launch files ends here: {what}.", place)
        return False

    def _execute(self, action: tree.LaunchAction, at: At) -> None:
        missing = "what this starts or sets is missing"
        failed = guarded(lambda: self._execute_kind(action, at), action.place, missing, net=self._budget.net)
        if failed is not None:
            self.scene.findings.add(failed)

    def _execute_kind(self, action: tree.LaunchAction, at: At) -> None:
        self._agenda.executed(action, at)
        inner = at._replace(depth=at.depth + 1)
        if isinstance(action, SETTINGS):
            change(action, self.scene)
        elif isinstance(action, tree.StartNode):
            self._start(action, inner)
        elif isinstance(action, tree.StartProcess):
            self._start_process(action, inner)
        elif isinstance(action, tree.LoadComponents):
            self._load(action, at)
        elif isinstance(action, tree.Include):
            self._include(action, inner)
        elif isinstance(action, tree.Group):
            self._group(action, inner)
        elif isinstance(action, tree.Maybe):
            message = (
                f"Whether this is part of the launch description depends on {action.why}. Both branches are analysed."
            )
            self.scene.findings.tell("RW316", message, action.place)
            for each in action.actions:
                self._by(Truth(why=action.why), partial(self.walk, (each,)), inner)
        elif isinstance(action, (tree.Timer, tree.OnEvent)):
            self._wait(action, inner)
        elif isinstance(action, tree.Opaque):
            given = action.args, dict(action.kwargs)
            self.walk(self._called(action.function, *given, inner, context=True), inner)
        elif isinstance(action, tree.Added):
            self._add(action.description, at)
        elif isinstance(action, tree.ForEach):
            self._loop(action, inner)
        elif isinstance(action, tree.Unread):
            self.scene.context.unread = True
            self.scene.findings.tell("RW321", f"Not supported: {action.why.rstrip('.')}.", action.place)
        elif not isinstance(action, tree.Inert):
            raise TypeError(f"a {type(action).__name__} has no execution")

    def _called(
        self, function: Value, args: Sequence[Value], kwargs: Mapping[str, Value], at: At, *, context: bool
    ) -> tuple[tree.LaunchAction, ...]:
        """The actions that a function gives; those that it adds to launch descriptions wait for the ends of these."""
        found = self.scene.python.actions(function, args, kwargs, self.scene, context=context)
        for description, actions in self.scene.python.appended(function, self.scene).items():
            self._added.setdefault(description, []).append((actions, at.why))
        return found

    # What starts something

    def _again(self, action: tree.LaunchAction, at: At) -> bool:
        """Whether launch refuses to start a process since the same object has surely started one before."""
        if action.identity is None or action.several or at.conditional or at.event:
            return False
        key = at.load, action.identity
        if key not in self._executed:
            self._executed.add(key)
            return False
        self.scene.fails(
            "the same action is executed a second time, which launch refuses: make one for each", action.place
        )
        return True

    def _start(self, action: tree.StartNode, at: At) -> None:
        if self._again(action, at):
            return
        if action.kind is tree.NodeKind.CONTAINER or action.components:
            self._containers[_key(action)] = container_name(action, self.scene)
        self.started += start_node(action, self.scene, at)
        self._load_into(self._containers.get(_key(action), Const("")), action.components, at)
        self._agenda.add_on_exit(action.on_exit, action.place, at)

    def _load(self, action: tree.LoadComponents, at: At) -> None:
        if not isinstance(action.target, tree.StartNode):
            container = self.scene.text(action.target)
        elif _key(action.target) in self._containers:
            container = self._containers[_key(action.target)]
        else:
            self.scene.fails("the container is not started earlier", action.place)
            container = container_name(action.target, self.scene)
        components = action.components
        if not self.scene.distro.facts.components_have_conditions:
            components = tuple(replace(component, condition=None) for component in components)
        self._load_into(container, components, at)

    def _load_into(self, container: Value, components: Sequence[tree.Component], at: At) -> None:
        for component in components:
            verdict = decide(component.condition, self.scene)
            if verdict.true:
                way = at.maybe(verdict.why) if verdict.open else at
                self.started += load_component(component, container, self.scene, way)

    def _start_process(self, action: tree.StartProcess, at: At) -> None:
        if self._again(action, at):
            return
        for found in start_process(action, self.scene, at):
            if isinstance(found, Started):
                self.started.append(found)
            else:
                self._launch(found, action.place, at)
        self._agenda.add_on_exit(action.on_exit, action.place, at)

    def _launch(self, launch: Launch, place: Place, at: At) -> None:
        """`ros2 launch`: a system of its own, which gets the environment but no configurations."""
        path = launch.file
        if launch.package is not None:
            share = folder(Cause.SHARE, launch.package, place)
            paths = [joined(share, joined(Const(f), launch.file)) for f in ("launch", "")]
            path = next((p for p in paths if self.scene.files.find(p) is not None), paths[0])
        inner = at._replace(trail=(*at.trail, Inclusion(place, "", self._budget.left)))
        if not self._allowed(place, inner):
            return
        file = self._descriptions.find(path, place)
        if file is None:
            return
        outer = self.scene
        scene = Scene(
            outer.files,
            outer.python,
            outer.findings,
            outer.generated,
            outer.distro,
            SUBSTITUTIONS,
            outer.shell,
            outer.variables,
        )
        scene.words = tuple(f"{name}:={readable(value)}" for name, value in launch.arguments.items())
        for name, value in self.scene.context.environment(place).items():
            scene.set_variable(name, value)
        for name, value in launch.arguments.items():
            scene.set_configuration(name, value)
        system = RunningLaunch(scene, self._descriptions, self._budget)
        system.run(file, path, inner.inside(file))
        self.started += system.started

    # What holds other actions

    def _group(self, action: tree.Group, at: At) -> None:
        context = self.scene.context
        kept = performed(action.configurations, self.scene)
        if action.scoped:
            context.push_configurations()
            context.push_environment()
            if not action.forwarding:
                context.reset_environment()
                context.reset_configurations(kept)
        if not action.scoped or action.forwarding:
            for name, value in kept:
                context.set(name, value)
        self.walk(action.actions, at)
        if action.scoped:
            context.pop_environment()
            context.pop_configurations()

    def _include(self, action: tree.Include, at: At) -> None:
        inner = at._replace(trail=(*at.trail, Inclusion(action.place, "", self._budget.left)))
        if action.path is None:
            self._set_arguments(action)
            self.walk(action.body, inner)
            return
        paths = options(self.scene.text(action.path))
        for path in paths:
            verdict = Truth(why="which launch file is included") if len(paths) > 1 else Truth(false=False)
            self._by(verdict, partial(self._include_file, action, path), inner)

    def _include_file(self, action: tree.Include, path: Value, at: At) -> None:
        """The current launch file changes before the arguments are performed, and does not change back."""
        file = self._descriptions.find(path, action.place)
        description = None
        if file is not None and self._allowed(action.place, at):
            description = self._descriptions.read(file, action.format, self.scene)
        if description is None:
            self.scene.context.unread = True
        self.scene.context.files = (normal_path(path),)
        self._set_arguments(action)
        if description is not None and file is not None:
            self.walk(description.actions, at.inside(file)._replace(load=self._load_of(action, at)))

    def _load_of(self, action: tree.Include, at: At) -> int:
        fresh = self._budget.left
        return fresh if action.loader is None else self._loads.setdefault((at.load, action.loader), fresh)

    def _set_arguments(self, action: tree.Include) -> None:
        for name, value in action.arguments:
            for plain, text in performed(((name, value),), self.scene):
                self.scene.context.set(plain, text)

    def _loop(self, action: tree.ForEach, at: At) -> None:
        outer = self.scene.turn
        for turn in turns(action, self.scene):
            self._by(turn.verdict, partial(self._turn, action, turn), at)
        self.scene.turn = outer

    def _turn(self, action: tree.ForEach, turn: Turn, at: At) -> None:
        self.scene.turn = {**self.scene.turn, **turn.variables}
        if action.function is not None:
            named = dict.fromkeys("i", *turn.variables.values()) if action.count else turn.variables
            self.walk(self._called(action.function, (), named, at, context=False), at)
        self.walk(action.body, at)

    # What waits

    def _wait(self, action: tree.Timer | tree.OnEvent, at: At) -> None:
        if isinstance(action, tree.Timer):
            self._agenda.add_timer(action, _seconds(self.scene.text(action.period)), self.scene.context.files, at)
        else:
            self._agenda.add_handler(action, at)

    def _fire(self, later: Later) -> None:
        self.scene.context.files = later.files
        self.scene.turn = {}
        at = self._agenda.circumstances(later)
        verdict = Truth(why=at.why[-1]) if at.conditional and at.why else Truth(false=False)
        self._by(verdict, lambda way: self._react(later, way), at)

    def _react(self, later: Later, at: At) -> None:
        self.walk(later.actions, at)
        if later.function is not None:
            event = Unknown((Reason(Cause.LIVE, "event", later.place),))
            alone = later.at.event == "process-io"  # the one handler that is not given the context
            function = later.function if alone else Partial(later.function, (event,), ())
            self.walk(self._called(function, (event,) if alone else (), {}, at, context=not alone), at)


def _key(node: tree.StartNode) -> tuple[Place, object, object]:
    return node.place, node.name, node.namespace


def _seconds(period: Value) -> float:
    """The time of a timer; where it is not known, at the end of all."""
    try:
        return float(plain_text(period) or "")
    except ValueError:
        return 1e9
