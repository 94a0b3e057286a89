# SPDX-License-Identifier: Apache-2.0
"""Python of launch files, interpreted: `generate_launch_description()` and everything that launch calls later.

    def generate_launch_description():                      read(file, performer)      ->  Description((Declare(…), Opaque(…)))
        return LaunchDescription([DeclareLaunchArgument('n'), OpaqueFunction(function=setup)])
    def setup(context): return [Node(…)]                    actions(setup, …)          ->  (StartNode(…),)

Nothing is executed: the engine runs the code abstractly, in one interpreter for all launch files of a system, so that modules keep what
they hold. Each run of a file and each call has a context of its own, as launch runs a file anew with each include.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final, final

from rosward.deadline import Deadline
from rosward.deployment.python.actions import Actions
from rosward.deployment.python.context import PerformedContext
from rosward.deployment.python.expression import Expressions
from rosward.deployment.python.objects import Objects
from rosward.deployment.tree import Description, Unread
from rosward.domain.choice import join_all, options
from rosward.domain.compound import BoundMethod, Partial
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause, Origin
from rosward.domain.values import NONE, TRUE, UNBOUND, Const, Function, ModuleValue, Ref, Text, Unknown, Value
from rosward.effects.log import EffectLog
from rosward.effects.variables import Variables
from rosward.engine.budget import Budget, LimitReachedError
from rosward.engine.interpreter import Interpreter
from rosward.engine.python import modules
from rosward.engine.running.frame import Frame
from rosward.findings import Finding
from rosward.frontends.registry import PYTHON
from rosward.ir.ops import Op
from rosward.location import Place

if TYPE_CHECKING:
    from rosward.deployment.performer import Performer
    from rosward.deployment.tree import LaunchAction
    from rosward.engine.libraries.library import Library
    from rosward.ir.program import Code

_CALLS: Final = 3
"""All Python of a system together may take this many times what the budget allows for one call."""

_GENERATE: Final = "generate_launch_description"
_CONDITION: Final = "launch.condition.Condition"
_DESCRIPTION: Final = "launch.launch_description.LaunchDescription"


@final
class LaunchPython:
    """Implements `performer.PythonCode` for one launched system."""

    def __init__(self, library: Library, budget: Budget | None = None, variables: Variables | None = None) -> None:
        self._budget = budget or Budget()
        self._log = EffectLog()
        self._log.variables = variables or Variables()
        self._machine = Interpreter(library, self._budget, self._log)
        self._objects = Objects(self._machine)
        self._read = Actions(self._objects)
        self._context = PerformedContext(self._read.texts, self.test)
        self._log.launch = self._context
        self._expressions = Expressions(self._machine)
        self._most = _CALLS * self._budget.steps
        self._end = Deadline(self._budget.seconds)
        self._roots: dict[str, Code] = {}
        self._turns = 0
        self._started: Performer | None = None  # the execution whose command line sys.argv is

    @property
    def findings(self) -> Sequence[Finding]:
        """What the engine had to tell so far: a call that fails is a launch that fails."""
        told = (f._replace(code="RW320") if f.code == "RW209" else f for f in self._log.findings)
        return tuple(dict.fromkeys(told))

    @property
    def log(self) -> EffectLog:
        """What the launch files did to ROS themselves: nodes that live in the process of launch."""
        return self._log

    def read(self, file: str, performer: Performer) -> Description:
        """Run a Python launch file (named as in the workspace) and give the entities of its generate_launch_description()."""
        try:
            with self._running(performer, Place(file)) as turn:
                if self._started is not performer:
                    self._started = performer
                    self._give_arguments(performer.given(), file)
                return Description(self._description(file, turn), file)
        except LimitReachedError as limit:
            self._limit(limit, Place(file))
            return Description((Unread(place=Place(file), why=limit.what),), file)

    def _description(self, file: str, turn: int) -> tuple[LaunchAction, ...]:
        machine, place = self._machine, Place(file)
        if machine.library.module(file) is None:
            self._tell("RW310", "the file cannot be read", place)
            return (Unread(place=place, why="the launch file cannot be read"),)
        name = file.rpartition("/")[2].removesuffix(".py")
        module = ModuleValue(machine.place_key(("launch", file, turn)), name, file)
        if not machine.run_module(module, name, turn):
            self._tell("RW320", "this launch file raises an exception when it is loaded", place)
            return ()
        generate = modules.attribute(machine, module, _GENERATE)
        if isinstance(generate, Unknown) and _GENERATE not in machine.at(module.address).attrs:
            self._tell("RW310", f"this launch file has no function {_GENERATE}", place)
            return ()
        value = machine.call(generate, ())
        here = _place_of(generate) or place
        if value is UNBOUND:
            self._tell("RW320", f"{_GENERATE}() raises an exception", here)
            return ()
        for option in options(value):
            if not self._objects.is_a(option, _DESCRIPTION) and not isinstance(option, Unknown):
                self._tell("RW320", f"{_GENERATE}() does not return a LaunchDescription", here)
        if len(options(value)) > 1 and all(self._objects.is_a(o, _DESCRIPTION) for o in options(value)):
            # An early return: what all descriptions have in common is surely there.
            return self._read.one_of(options(value), here)
        return self._read.entities(value, here)

    def actions(
        self,
        function: Value,
        args: Sequence[Value],
        kwargs: Mapping[str, Value],
        performer: Performer,
        *,
        context: bool,
    ) -> tuple[LaunchAction, ...]:
        """Call a function and read the entities that it gives; with `context`, the launch context is its first argument."""
        place = self._place(function)
        try:
            with self._running(performer, place):
                given = (self._launch_context(), *args) if context else tuple(args)
                value = self._machine.call(function, given, kwargs)
                if value is UNBOUND:
                    self._tell("RW320", "this function raises an exception", place)
                    return ()
                return self._read.entities(value, place)
        except LimitReachedError as limit:
            self._limit(limit, place)
            return (Unread(place=place, why=limit.what),)

    def appended(self, function: Value, performer: Performer) -> Mapping[Value, tuple[LaunchAction, ...]]:
        """The actions that a function, which was called, has added to launch descriptions, by description."""
        place = self._place(function)
        try:
            with self._running(performer, place):
                return self._read.appended(place)
        except LimitReachedError as limit:
            self._limit(limit, place)
            return {}

    def perform(self, substitution: Value, performer: Performer) -> Value:
        """`substitution.perform(context)` of a class of the analysed sources; also one of several substitutions: a text."""
        place = self._place(substitution)
        try:
            with self._running(performer, place):
                return join_all(self._perform(o) for o in options(substitution))
        except LimitReachedError as limit:
            self._limit(limit, place)
            return self._machine.unknown(Cause.LIMIT, limit.what, "str")

    def _perform(self, value: Value) -> Value:
        if isinstance(value, Ref) and self._objects.overrides(value, "perform"):
            found = self._machine.call_method(value, "perform", (self._launch_context(),))
            if found is UNBOUND:
                self._tell("RW320", "perform() raises an exception", self._objects.place(value))
        else:
            found = NONE if value == NONE else self._context.perform(value)
        text = _as_text(found)
        return self._machine.unknown(Cause.CALL, "perform", "str") if text is None else text

    def test(self, condition: Value, performer: Performer) -> Value:
        """`condition.evaluate(context)` of a class of the analysed sources, or a call of a function: a bool."""
        place = self._place(condition)
        try:
            with self._running(performer, place):
                return join_all(self._test(o) for o in options(condition))
        except LimitReachedError as limit:
            self._limit(limit, place)
            return self._machine.unknown(Cause.LIMIT, limit.what, "bool")

    def _test(self, value: Value) -> Value:
        machine = self._machine
        if value == NONE:
            return TRUE
        if isinstance(value, Unknown):
            return Unknown(value.reasons, "bool")
        if isinstance(value, Ref) and self._objects.overrides(value, "evaluate"):
            found = machine.call_method(value, "evaluate", (self._launch_context(),))
        elif self._objects.is_a(value, _CONDITION):
            return self._context.evaluate(value)
        elif isinstance(value, Ref) and not self._objects.overrides(value, "__call__"):
            self._tell("RW320", "this is not a condition", self._place(value))
            return machine.unknown(Cause.ERROR, "condition", "bool")
        else:
            found = machine.call(value, (self._launch_context(),))
        if found is UNBOUND:
            self._tell("RW320", "this condition raises an exception", self._place(value))
            return machine.unknown(Cause.ERROR, "condition", "bool")
        truth = machine.truth(found)
        if truth is None:
            reasons = found.reasons if isinstance(found, Unknown) else machine.unknown(Cause.CALL, "condition").reasons
            return Unknown(reasons, "bool")
        return Const(truth, found.origins) if isinstance(found, Const) else Const(truth)

    def evaluate(self, expression: Value, modules: Sequence[str], performer: Performer) -> Value:
        """The str() of a Python expression, as PythonExpression has it: a text. The names of `modules` and of math are there."""
        place = self._place(expression)
        try:
            with self._running(performer, place) as turn:
                return self._expressions.evaluate(expression, tuple(modules), turn)
        except LimitReachedError as limit:
            self._limit(limit, place)
            return self._machine.unknown(Cause.LIMIT, limit.what, "str")

    # Running

    @contextmanager
    def _running(self, performer: Performer, place: Place) -> Iterator[int]:
        """A call from outside, for what stands at `place`: it may come while another one waits for the answer to its own question."""
        machine = self._machine
        self._turns += 1
        if place.file not in self._roots:
            self._roots[place.file] = PYTHON.lower("", place.file, name=f"what starts in {place.file}").code
        context = machine.context("launch", self._turns)
        root = Frame(self._roots[place.file], [], (), machine.library.nowhere, context, stub=False)
        root.op = Op(place.line, place.column)
        frames, catchers = machine.frames, machine.catchers
        machine.frames, machine.catchers = [*frames, root], []
        self._context.performers.append(performer)
        limits = machine.precision.step_limit, machine.precision.deadline
        if not frames:
            machine.precision.step_limit = min(machine.precision.steps + self._budget.steps, self._most)
            machine.precision.deadline = self._end
        try:
            yield self._turns
        finally:
            self._context.performers.pop()
            machine.frames, machine.catchers = frames, catchers
            if frames:
                machine.precision.step_limit, machine.precision.deadline = limits

    def _give_arguments(self, given: Sequence[str], file: str) -> None:
        """`sys.argv` is that of `ros2 launch PACKAGE FILE name:=value …` with the first file that an execution reads."""
        machine = self._machine
        package, path = machine.library.sources.shared(file) or ("", file)
        where = (Const(package), Const(path.rpartition("/")[2])) if package else (Const(path),)
        arguments = (Const(w, frozenset({_origin(w)})) for w in given)
        words = (Const(*_PROGRAM), Const("launch"), *where, *arguments)
        machine.store_attr(machine.load_module("sys"), "argv", machine.new_list(words))

    def _place(self, value: Value) -> Place:
        """Where a function is defined, or an object was made; else what is running now."""
        first = options(value)[0]
        found = self._objects.place(first) if isinstance(first, Ref) else _place_of(first)
        return found if found is not None and found.file else self._machine.place

    def _launch_context(self) -> Value:
        machine = self._machine
        cls = machine.load_attr(machine.load_module("launch.launch_context"), "LaunchContext")
        return machine.allocate(Obj("instance", cls), "context")

    def _limit(self, limit: LimitReachedError, place: Place) -> None:
        where = limit.place if limit.place.file else place
        self._tell("RW201", f"{limit.what}: what is launched after this is missing", where)

    def _tell(self, code: str, message: str, place: Place) -> None:
        self._objects.tell(code, message, place)


def _place_of(function: Value) -> Place | None:
    """Where a function is defined."""
    if isinstance(function, Function):
        return Place(function.code.file, function.code.line)
    if isinstance(function, (BoundMethod, Partial)):
        return _place_of(function.function)
    return None


_PROGRAM: Final = ("/opt/ros/distro/bin/ros2", frozenset({Origin("argument", "sys.argv[0]", settled=True)}))
"""The first word: surely the path of a program and no `name:=value`, whatever it is."""


def _origin(word: str) -> Origin:
    return Origin("launch argument", word.partition(":=")[0], settled=True, given=True)


def _as_text(value: Value) -> Value | None:
    """A value that is a text (each alternative of it), else None."""
    found = list(options(value))
    if all(isinstance(o, Text) or (isinstance(o, Const) and isinstance(o.value, str)) for o in found):
        return value
    if all(isinstance(o, (Text, Unknown)) or (isinstance(o, Const) and isinstance(o.value, str)) for o in found):
        return join_all(Unknown(o.reasons, "str") if isinstance(o, Unknown) else o for o in found)
    return None
