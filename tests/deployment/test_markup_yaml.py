# SPDX-License-Identifier: Apache-2.0
"""YAML launch files and the actions that they are. YAML has types, which launch checks instead of converting."""

from __future__ import annotations

import pytest

from deployment.markup_tree import expected, yaml

CASES = {
    "nodes and their parameters": (
        """
        launch:
        - arg: {name: id, default: "1"}
        - node:
            pkg: demo
            exec: talker
            name: talker_$(var id)
            if: $(var run)
            args: --rate $(var rate)
            remap:
            - {from: chatter, to: news}
            env:
            - name: A
              value: b
            param:
            - {name: whole, value: 1}
            - {name: exact, value: 1.0}
            - {name: flag, value: on}
            - {name: text, value: "1"}
            - {name: list, value: [1, 2]}
            - {name: words, value: [a, $(var b)]}
            - {name: open, value: $(var x), type: int}
            - name: pid
              param:
              - {name: p, value: 0.5}
            - {from: p.yaml, allow_substs: true}
        """,
        """
        2: Declare name=id default=1
        3: StartNode condition=if[$(var <run>)] package=demo executable=talker name=talker_$(var <id>) remappings=[[chatter, news]]
                arguments=[--rate, $(var <rate>)] environment=[[A, b]]
            15: whole = 1
            16: exact = 1.0
            17: flag = True
            18: text = '1'
            19: list = [1, 2]
            20: words = several['a', typed[$(var <b>)] as yaml]
            21: open = typed[$(var <x>)] as int
            22: pid.p = 0.5
            25:file[p.yaml] with substitutions
        """,
    ),
    "actions inside are the list itself, or stand below children": (
        """
        launch:
        - group:
          - push_ros_namespace: {namespace: left}
          - reset_env: {}
        - group:
            scoped: false
            keep:
            - {name: a, value: b}
            children:
            - let: {name: a, value: b}
        - timer:
            period: 1.5
            children:
            - log: {message: now}
        - include:
            file: $(dirname)/other.yaml
            let:
            - {name: id, value: "2"}
        """,
        """
        2: Group
            3: PushNamespace namespace=left
            4: ScopeChange what='environment' how='reset'
        5: Group scoped=False configurations=[[a, b]]
            10: SetConfiguration name=a value=b
        11: Timer period=1.5
            14: Inert kind='log'
        15: Include path=$(dirname)/other.yaml arguments=[[id, 2]]
        """,
    ),
    "components": (
        """
        launch:
        - node_container:
            pkg: rclcpp_components
            exec: component_container
            name: box
            namespace: ""
            composable_node:
            - {pkg: demo, plugin: "demo::Talker", name: talker}
        - load_composable_node:
            target: box
            composable_node:
            - {pkg: demo, plugin: "demo::Listener", name: listener}
        """,
        """
        2: StartNode kind=container package=rclcpp_components executable=component_container name=box namespace=
            8: Component package=demo plugin=demo::Talker name=talker
        9: LoadComponents target=box
            12: Component package=demo plugin=demo::Listener name=listener
        """,
    ),
    "the whole below children": (
        """
        launch:
            children:
            - log: {message: a}
        """,
        """
        3: Inert kind='log'
        """,
    ),
    "anchors, aliases and merged keys": (
        """
        launch:
        - node: &talker
            pkg: demo
            exec: talker
            name: a
        - node:
            <<: *talker
            name: b
        - node: *talker
        """,
        """
        2: StartNode package=demo executable=talker name=a
        6: StartNode package=demo executable=talker name=b
        9: StartNode package=demo executable=talker name=a
        """,
    ),
    "a type that launch does not take": (
        """
        launch:
        - node: {pkg: demo, exec: talker, name: 5, respawn: true, if: true, respawn_delay: 2}
        - timer: {period: 5, children: []}
        - set_parameter: {name: rate, value: 10}
        - group: {scoped: 1, children: []}
        - node:
            pkg: demo
            exec: talker
            param:
            - {name: none, value: null}
            - {name: day, value: 2024-01-01}
            - {name: mixed, value: [1, 2.0]}
            - {name: exact, value: 1, type: float}
            - {name: deep, value: [[1]]}
        """,
        """
        2: StartNode condition=if[true] package=demo executable=talker name=5
        3: Timer period=5
        4: SetParameter parameter=4:{rate: typed[10]}
        5: Group
        6: StartNode package=demo executable=talker
            10: none = typed[null]
            11: day = typed[2024-01-01]
            12: mixed = [1, 2.0]
            13: exact = 1
            14: deep = typed[$(unknown <value>)]
        RW320 2: 'name' of <node> is of type int, but launch requires a string: quote it.
        RW320 2: 'respawn' of <node> is of type bool, but launch requires a string: quote it.
        RW320 2: 'if' of <node> is of type bool, but launch requires a string: quote it.
        RW320 2: 'respawn_delay' of <node> must be a non-negative float; substitutions are not allowed.
        RW320 3: 'period' of <timer> is of type int, but launch requires float.
        RW320 4: 'value' of <set_parameter> is of type int, but launch requires a string: quote it.
        RW320 5: 'scoped' of <group> is of type int, but launch requires true or false.
        RW320 10: The value of <param> is not a valid parameter value.
        RW320 11: The value of <param> is not a valid parameter value.
        RW320 12: The list in <param> has elements of several types.
        RW320 13: 1 in <param> is not of type float.
        RW320 14: The value of <param> is not a valid parameter value.
        """,
    ),
    "a shape that launch does not take": (
        """
        launch:
        - node: {pkg: demo, exec: talker, nmae: t, parma: [{a: b}]}
        - node: {pkg: demo, exec: talker, remap: {from: a, to: b}}
        - node:
          pkg: demo
          exec: talker
        - group: {if: "true"}
        - let:
          - log: {message: a}
        - reset_env:
        - just text
        - let: {name: a, name: b, value: c}
        - wait: {for: it}
        """,
        """
        2: StartNode package=demo executable=talker
        3: StartNode package=demo executable=talker
        7: Group condition=if[true]
        8: SetConfiguration name=$(unknown <name>) value=$(unknown <value>)
        10: ScopeChange what='environment' how='reset'
        12: SetConfiguration name=b value=c
        13: Unread why='The tag <wait> is unknown.'
        RW320 2: Unexpected attribute 'nmae' of <node>.
        RW320 2: Unexpected nested tag <parma> in <node>.
        RW320 3: 'remap' of <node> is not a list of mappings, which launch expects.
        RW320 4: An action must be a mapping with its tag as the only key.
        RW320 7: <group> has no nested entities: launch expects a list, or a list below the key 'children'.
        RW320 8: <let> has no attribute 'name', which launch requires.
        RW320 8: <let> has no attribute 'value', which launch requires.
        RW320 8: Unexpected nested entities in <let>.
        RW320 10: <reset_env> is not a mapping, which launch expects ({} if it has no attributes).
        RW320 11: An action must be a mapping with its tag as the only key.
        RW320 12: The key 'name' occurs twice in one mapping: launch uses the last one and ignores the first.
        """,
    ),
}


@pytest.mark.parametrize(("text", "tree"), CASES.values(), ids=CASES)
def test_actions(text: str, tree: str) -> None:
    assert yaml(text) == expected(tree)
