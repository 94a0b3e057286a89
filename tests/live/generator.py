# SPDX-License-Identifier: Apache-2.0
"""Random ROS 2 programs made of what real code does: `write(chooser)` gives the files of one.

    write(Seeded(7)).files    ->  {"main.py": "import rclpy …", "config.py": "NAME1 = 'left'"}

With `known`, all that decides about the graph is in the program: the static answer should be exact. Without, conditions may depend on
what only a run knows; the static answer must still cover what runs.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from .calls import CALL_WAYS
from .constructs import FURTHER_STATEMENTS, FURTHER_WAYS
from .constructs.arguments import cli_args, init_call
from .constructs.overridden import node_base
from .draft import Chooser, Draft, Scope, block
from .entities import STATEMENTS, create
from .hazards import HAZARDS
from .node_values import NODE_WAYS
from .values import WAYS, concatenation, constant, format_method, fstring, imported, percent, word

_HEAD: Final = """import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci
"""
_DEPTH: Final = 2
_LABELS: Final = (constant, concatenation, fstring, format_method, imported, percent)
"""What the names of nodes are made by: one node has one name."""


class Written(NamedTuple):
    """A program: its files, and the names of the patterns in it."""

    files: dict[str, str]
    used: frozenset[str]


def write(chooser: Chooser, *, known: bool = True, further: bool = True) -> Written:
    """A program of one to three nodes. Without `further`, it is made without what stands in `constructs/`."""
    ways = (*WAYS, *CALL_WAYS, *HAZARDS, *(FURTHER_WAYS if further else ()))
    statements = (*STATEMENTS, *(FURTHER_STATEMENTS if further else ()))
    draft = Draft(chooser, known, ways=ways, node_ways=NODE_WAYS, statements=statements, further=further)
    nodes = [_node(draft) for _ in range(chooser.pick([1, 1, 1, 2, 3]))]
    main = _main(draft, nodes)
    files = {name: "\n".join(lines) + "\n" for name, lines in draft.files.items()}
    imports = "\n".join(sorted(draft.imports))
    files["main.py"] = f"{_HEAD}{imports}\n\n" + "\n\n".join([*draft.module, main]) + "\n"
    return Written(files, frozenset(draft.used))


def _node(draft: Draft) -> str:
    """Define how a node is made; the expression that makes it."""
    chooser = draft.chooser
    kind = chooser.number(0, 7)
    name = draft.fresh("Robot")
    if kind == 0:
        return _without_class(draft)
    base = node_base(draft)
    own, methods = _body(draft)
    options = _options(draft)
    label = _label(draft)
    parts = block(["\n".join(methods)] if methods else [], 1) if methods else ""
    if kind <= 3:
        draft.define(
            f"class {name}({base}):\n    def __init__(self):\n"
            f"        super().__init__({label}{options})\n{block(own, 2)}\n{parts}"
        )
        return f"{name}()"
    if kind == 4:
        draft.define(
            f"class {name}Base({base}):\n    def __init__(self, name, *args, **kw):\n"
            "        super().__init__(name, *args, **kw)\n        self.setup_all()\n"
            "    def setup_all(self):\n        self.create_publisher(String, 'base_only', 10)\n"
            f"    def after(self):\n        pass\n\n\nclass {name}({name}Base):\n"
            f"    def __init__(self):\n        super().__init__({label}{options})\n"
            "        self.after()\n    def setup_all(self):\n        super().setup_all()\n"
            f"{block(own, 2)}\n{parts}"
        )
        return f"{name}()"
    if kind == 5:
        draft.define(
            f"class {name}Mixin:\n    def add_state(self, topic):\n"
            "        self.state = self.create_publisher(String, topic + '_state', 10)\n\n\n"
            f"class {name}({name}Mixin, {base}):\n    def __init__(self, name, namespace=''):\n"
            f"        {base}.__init__(self, name, namespace=namespace)\n"
            f"        self.add_state(name)\n{block(own, 2)}\n{parts}"
        )
        return f"{name}({label}, namespace={chooser.pick(['None', repr('given'), repr('/given/ns')])})"
    if kind == 6:
        draft.define(
            f"class {name}({base}):\n    def create_publisher(self, msg_type, topic, *args, **kw):\n"
            "        if topic.startswith('/'):\n"
            "            return super().create_publisher(msg_type, topic, *args, **kw)\n"
            "        return super().create_publisher(msg_type, 'over_' + topic.replace('~/', ''), *args, **kw)\n"
            f"    def __init__(self):\n        super().__init__({label}{options})\n"
            f"{block(own, 2)}\n{parts}"
        )
        return f"{name}()"
    draft.define(
        f"class {name}({base}):\n    default_name = {label}\n"
        "    def __init__(self, name=None, **kw):\n"
        f"        super().__init__(name or self.default_name, **kw)\n{block(own, 2)}\n{parts}\n"
        "    @classmethod\n    def make(cls, *args):\n        return cls(*args)"
    )
    return chooser.pick(
        [f"{name}()", f"{name}.make()", f"{name}({draft.fresh('given')!r})", f"{name}(namespace='spaced')"]
    )


def _label(draft: Draft) -> str:
    """An expression for the name of a node."""
    name = draft.fresh("node")
    if draft.chooser.chance(70):
        return repr(name)
    top, ways = Scope(), draft.ways
    draft.ways = _LABELS
    text = word(draft, top, 1)
    draft.ways = ways
    draft.module += top.lines
    return f"({name + '_'!r} + ({text}).replace('/', '_'))"


def _options(draft: Draft) -> str:
    chooser = draft.chooser
    options = ""
    if chooser.chance(30):
        options += f", namespace={chooser.pick([repr('ns'), repr('/deep/ns'), repr(''), 'None'])}"
    if chooser.chance(20):
        options += f", cli_args={cli_args(draft)}"
    if chooser.chance(15):
        draft.need("from rclpy.parameter import Parameter")
        options += ", parameter_overrides=[Parameter('param1', Parameter.Type.STRING, 'overridden')]"
    if chooser.chance(15):
        options += chooser.pick(
            [
                ", enable_rosout=False",
                ", start_parameter_services=False",
                ", allow_undeclared_parameters=True",
                ", automatically_declare_parameters_from_overrides=True",
                ", use_global_arguments=False",
                ", enable_logger_service=True",
            ]
        )
    return options


def _body(draft: Draft) -> tuple[list[str], list[str]]:
    """What a constructor does, and the methods that it needs."""
    methods: list[str] = []
    scope = Scope([], "self", [], methods)
    create(draft, scope, _DEPTH)
    return scope.lines, methods


def _without_class(draft: Draft) -> str:
    name = draft.fresh("make_node")
    scope = Scope([], "node", [], None)
    create(draft, scope, _DEPTH)
    maker = draft.chooser.pick(["rclpy.create_node", "Node"])
    draft.define(
        f"def {name}():\n    node = {maker}({_label(draft)}{_options(draft)})\n{block(scope.lines)}\n    return node"
    )
    return f"{name}()"


def _main(draft: Draft, nodes: list[str]) -> str:
    chooser = draft.chooser
    start = init_call(draft)
    made = "[" + ", ".join(nodes) + "]"
    if len(nodes) > 1 or chooser.chance(30):
        draft.need("from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor")
        executor = chooser.pick(["MultiThreadedExecutor", "SingleThreadedExecutor"])
        spin = [
            f"nodes = {made}",
            f"executor = {executor}()",
            "for each in nodes:",
            "    executor.add_node(each)",
            "executor.spin()",
            "for each in nodes:",
            "    each.destroy_node()",
        ]
    else:
        spin = [
            f"node = {nodes[0]}",
            *chooser.pick(
                [
                    ["rclpy.spin(node)"],
                    ["while rclpy.ok():", "    rclpy.spin_once(node, timeout_sec=0.1)"],
                    ["for _ in range(3):", "    rclpy.spin_once(node)"],
                    [],
                ]
            ),
        ]
    shape = chooser.number(0, 4)
    if shape == 0:
        body = [
            start,
            "try:",
            *block(spin).splitlines(),
            "except KeyboardInterrupt:",
            "    pass",
            "finally:",
            "    rclpy.try_shutdown()",
        ]
    elif shape == 1 and start == "rclpy.init()":
        body = ["with rclpy.init():", *block(spin).splitlines()]
    else:
        body = [start, *spin, *(["rclpy.try_shutdown()"] if shape == 2 else [])]
    if shape == 3:
        return "\n".join(body)
    return f"def main():\n{block(body)}\n\n\nif __name__ == '__main__':\n    main()"
