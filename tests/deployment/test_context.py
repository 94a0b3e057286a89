# SPDX-License-Identifier: Apache-2.0
"""The state of an execution: scopes, and what holds after one of two ways."""

from __future__ import annotations

from rosward.deployment.execution.context import Context, Held
from rosward.deployment.execution.ros_state import Remap, RosState
from rosward.domain.choice import join
from rosward.domain.values import Const

ONE, TWO = Const("1"), Const("2")


def test_scopes_of_configurations() -> None:
    context = Context()
    context.set("x", ONE)
    context.push_configurations()
    context.set("x", TWO)
    context.set("y", TWO)
    assert context.configurations() == {"x": TWO, "y": TWO}
    assert context.pop_configurations()
    assert context.configurations() == {"x": ONE}
    assert not context.pop_configurations()


def test_both_ways() -> None:
    """set in one way only: it may be set; set differently: either value; the same in both: sure."""
    context = Context()
    context.set("x", ONE)
    context.set("z", ONE)
    saved = context.save()
    context.set("x", TWO)
    context.set("y", ONE)
    context.join(saved)
    assert context.held("x") == Held(join(ONE, TWO))
    assert context.held("y") == Held(ONE, sure=False)
    assert context.held("z") == Held(ONE)


def test_removed_in_one_way() -> None:
    context = Context()
    context.set("x", ONE)
    saved = context.save()
    context.set("x", None)
    context.join(saved)
    assert context.held("x") == Held(ONE, sure=False)


def test_a_saved_state_does_not_change() -> None:
    context = Context()
    context.set("x", ONE)
    saved = context.save()
    context.set("x", TWO)
    context.restore(saved)
    assert context.held("x") == Held(ONE)


def test_ways_of_different_depth() -> None:
    """A way that pushed without popping: what is popped later is popped in both."""
    context = Context()
    context.set("x", ONE)
    saved = context.save()
    context.push_configurations()
    context.set("x", TWO)
    context.change_ros(lambda state: state.with_namespace(TWO))
    context.join(saved)
    assert context.held("x") == Held(join(ONE, TWO))
    assert context.pop_configurations()
    assert {s.namespace for s in context.alternatives} == {None}


def test_alternatives_of_the_ros_state_are_kept_apart_and_bounded() -> None:
    context = Context()
    for index in range(5):
        saved = context.save()
        context.change_ros(lambda state, i=index: state.added(Remap(Const(str(i)), ONE)))  # type: ignore[misc]
        context.join(saved)
    assert len(context.alternatives) == 8
    assert context.exceeded


def test_a_list_is_shared_by_the_scopes_that_see_it() -> None:
    first, second = Remap(ONE, TWO), Remap(TWO, ONE)
    outside = RosState().added(first).pushed().added(second).popped()
    assert outside.remaps == (first, second)
    inside = RosState().pushed().added(second).popped()
    assert inside.remaps == ()


def test_a_variable_that_was_removed_is_not_that_of_the_shell() -> None:
    context = Context()
    assert context.variable("E") is None
    context.set_variable("E", None)
    assert context.variable("E") == Held(None)
    context.reset_environment()
    assert context.variable("E") is None
