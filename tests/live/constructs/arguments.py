# SPDX-License-Identifier: Apache-2.0
"""Which ROS arguments does a program give itself? Lists that it builds, alone or behind what it was started with.

rclpy.init(args=sys.argv + ["--ros-args", "-r", "left:=l2"])    the rule holds, whatever is typed before it
"""

from __future__ import annotations

from typing import Final

from ..draft import Draft, Scope, Statement, Way
from ..values import condition, word

_RULES: Final = (
    *(
        "'left:=all_left'",
        "'scan:=/all/scan'",
        "'__ns:=/global'",
        "'left:=' + 'joined'",
        "'right:={}'.format('formatted')",
    ),
    *("f'{\"map\"}:=mapped'", "'arm:=~/private'", "'~/left:=/tilde'", "'/odom:=abs_odom'"),
)
_START: Final = "sys.argv"


def rules(draft: Draft) -> list[str]:
    """The items of a list of ROS arguments."""
    items = ["'--ros-args'"]
    for _ in range(draft.chooser.number(1, 2)):
        if draft.chooser.chance(20):
            items += ["'-p'", "'param1:=from_line'"]
        else:
            items += [draft.chooser.pick(["'-r'", "'--remap'"]), draft.chooser.pick(_RULES)]
    if draft.chooser.chance(20):
        items.append("'--'")
        items.append("'plain'")
    return items


def built(draft: Draft) -> str:
    """An expression for a list that holds them."""
    items, name = rules(draft), draft.fresh("argv")
    if not draft.further:
        return f"[{', '.join(items)}]"
    listed, start = ", ".join(items), draft.chooser.pick([_START, "['prog']", "sys.argv[:1]", "list(sys.argv)"])
    draft.need("import sys")
    kind = draft.chooser.number(0, 7)
    if kind == 0:
        return f"{start} + [{listed}]"
    if kind == 1:
        return f"[*{start}, {listed}]"
    if kind == 2:
        draft.define(f"{name} = list({start})\n{name}.extend([{listed}])")
        return name
    if kind == 3:
        draft.define(f"{name} = {start}[:]\n{name} += [{listed}]")
        return name
    if kind == 4:
        draft.define(
            f"def {name}(given):\n    made = list(given)\n    for each in ({listed},):\n        made.append(each)\n    return made"
        )
        return f"{name}({start})"
    if kind == 5:
        draft.define(f"{name} = [{listed}]\nif {condition(draft, Scope(), 0)}:\n    {name} = {start} + {name}")
        return name
    if kind == 6:
        draft.define(
            f"{name} = [{', '.join(items[:1])}]\n{name}[0:0] = {start}\n{name}.extend(({', '.join(items[1:])},))"
        )
        return name
    draft.need("import itertools")
    return f"list(itertools.chain({start}, [{listed}]))"


def init_call(draft: Draft) -> str:
    """The call that starts rclpy."""
    plain = ["rclpy.init()", "rclpy.init()", "rclpy.init(args=None)", "rclpy.init(args=[])"]
    if not draft.chooser.chance(40):
        return draft.chooser.pick(plain)
    draft.used.add("built arguments")
    return f"rclpy.init(args={built(draft)})"


def cli_args(draft: Draft) -> str:
    """A list for `cli_args` of a node."""
    return built(draft) if draft.chooser.chance(50) else f"[{', '.join(rules(draft))}]"


def parsed(draft: Draft, scope: Scope, depth: int) -> str:
    """What the program parses out of a list of its own."""
    name, text = draft.fresh("parsed"), word(draft, scope, depth)
    draft.need("import argparse, sys")
    draft.need("from rclpy.utilities import remove_ros_args")
    kind = draft.chooser.number(0, 3)
    if kind == 0:
        scope.add(
            f"{name} = argparse.ArgumentParser()\n{name}.add_argument('--name', default={text})\n{name}.add_argument('rest', nargs='*')\n"
            f"{name} = {name}.parse_args({draft.chooser.pick(['[]', '[' + repr('--name') + ', ' + repr('line') + ']', '[' + repr('one') + ']'])})"
        )
        return draft.chooser.pick([f"{name}.name", f"'_'.join([{name}.name, *{name}.rest])"])
    if kind == 1:
        scope.add(f"{name} = remove_ros_args(args=['prog', {text}, '--ros-args', '-r', 'a:=b', '--', 'tail'])")
        return draft.chooser.pick([f"{name}[1]", f"{name}[-1]", f"'_'.join({name})"])
    if kind == 2:
        scope.add(f"{name} = ['--name', {text}]\n{name} = dict(zip({name}[::2], {name}[1::2]))")
        return f"{name}['--name']"
    scope.add(f"{name} = [*sys.argv[:0], {text}, 'second']")
    return draft.chooser.pick([f"{name}[0]", f"{name}[-1]"])


WAYS: Final[tuple[Way, ...]] = (parsed,)
STATEMENTS: Final[tuple[Statement, ...]] = ()
