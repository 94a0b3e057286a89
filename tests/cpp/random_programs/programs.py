# SPDX-License-Identifier: Apache-2.0
"""What does a whole program consist of? Classes of nodes, or functions that make nodes, and a main body."""

from __future__ import annotations

from typing import Final, NamedTuple

from . import numbers, texts
from .data import DATA
from .draft import BY_POINTER, GLOBAL_KEEP, OWN, Block, Draft, Pair, Ways
from .flow import FLOW
from .parameters import bool_parameter, int_parameter, text_parameter
from .said import SAID
from .shapes import SHAPES, class_methods
from .statements import message, published, statements
from .values import number, text

_PYTHON: Final = """import copy
import os
from enum import Enum
from typing import NamedTuple

import rclpy
from geometry_msgs.msg import Twist
from rclpy.action import ActionClient
from rclpy.exceptions import InvalidTopicNameException
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Bool, String
from std_srvs.srv import SetBool, Trigger
from test_msgs.action import Fibonacci

kept = []
"""
_CPP: Final = """#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"
#include "std_srvs/srv/trigger.hpp"
#include "test_msgs/action/fibonacci.hpp"

using namespace std::chrono_literals;
using namespace std::string_literals;

std::vector<std::shared_ptr<void>> kept;
"""

_WAYS: Final = {
    "text": Ways(texts.LEAVES, texts.PURE, (*SAID, text_parameter)),
    "number": Ways(numbers.LEAVES, numbers.NUMBERS, (int_parameter,)),
    "condition": Ways(numbers.COMPARISONS, numbers.CONDITIONS, (bool_parameter,)),
}
_STATEMENTS: Final = (*DATA, *FLOW, *FLOW)


class Written(NamedTuple):
    """One program in two languages; `open` where something that only a run knows decides about its graph."""

    python: str
    cpp: str
    used: frozenset[str]
    open: bool


def write(seed: int, *, known: bool = True) -> Written:
    """The program of a seed. With `known`, all that decides about its graph stands in it."""
    draft = Draft(seed, _WAYS, _STATEMENTS, known=known)
    main = Block(BY_POINTER, GLOBAL_KEEP)
    nodes = [draft.pick([_class, _class, _class, _without_class])(draft, main) for _ in range(draft.pick([1, 1, 2]))]
    start = Pair("    rclpy.init()\n", "  rclcpp::init(argc, argv);\n")
    if len(nodes) == 1 and draft.chance(70):
        spin = Pair(f"    rclpy.spin({nodes[0]})\n", f"  rclcpp::spin({nodes[0]});\n")
    else:
        spin = Pair(
            "    executor = SingleThreadedExecutor()\n"
            + "".join(f"    executor.add_node({n})\n" for n in nodes)
            + "    executor.spin()\n",
            "  rclcpp::executors::SingleThreadedExecutor executor;\n"
            + "".join(f"  executor.add_node({n});\n" for n in nodes)
            + "  executor.spin();\n",
        )
    top = draft.top
    return Written(
        f"{_PYTHON}\n\n{top.py}\n\n\ndef main():\n{start.py}{main.py()}\n{spin.py}    rclpy.shutdown()\n\n\nif __name__ == '__main__':\n    main()\n",
        f"{_CPP}\n{top.cpp}\n\nint main(int argc, char ** argv)\n{{\n{start.cpp}{main.cpp()}\n{spin.cpp}  rclcpp::shutdown();\n  return 0;\n}}\n",
        frozenset(draft.used),
        draft.open,
    )


def _body(draft: Draft, block: Block, count: int) -> None:
    """What a body of a node does: statements, and functions and classes of its own."""
    for _ in range(count):
        if draft.chance(45):
            shape = draft.pick(SHAPES)
            draft.use(shape.__name__)
            shape(draft, block, 0)
        else:
            statements(draft, block, 0, 1)


def _without_class(draft: Draft, main: Block) -> str:
    """A node that a function makes, or the main body itself; its name there."""
    node, label = draft.fresh("node"), draft.fresh("plain")
    space = draft.pick(["", "", "cell", "/deep/cell"])
    maker = draft.pick(["rclcpp::Node::make_shared", "std::make_shared<rclcpp::Node>"])
    made = Pair(
        f"Node('{label}'{f', namespace={space!r}' if space else ''})",
        f'{maker}("{label}"{f""", "{space}" """.rstrip() if space else ""})',
    )
    name, block = draft.fresh("make"), Block(BY_POINTER, GLOBAL_KEEP)
    _body(draft, block, draft.number(1, 3))
    draft.define(
        f"def {name}():\n    node = {made.py}\n{block.py()}\n    return node",
        f"rclcpp::Node::SharedPtr {name}()\n{{\n  auto node = {made.cpp};\n{block.cpp()}\n  return node;\n}}",
    )
    main.say(f"{node} = {name}()", f"auto {node} = {name}();")
    return node


def _class(draft: Draft, main: Block) -> str:
    """A class of nodes, perhaps with a base of its own, and one or two objects of it; the name of the first."""
    name = draft.fresh("Unit")
    base = _base(draft) if draft.chance(40) else None
    methods: list[Pair] = []
    label, side = draft.word() + draft.fresh("_"), text(draft, Block(OWN, GLOBAL_KEEP, pure=True))
    block = Block(OWN, Pair("self.keep", "keep_"), methods=methods, owner=name, constructing=True)
    block.members = [Pair("self.side", "side_"), Pair("self.topic", "topic_")]
    block.texts, block.local = [*block.members, Pair("side", "side")], ["side"]
    block.numbers = [Pair("self.count", "count_")]
    _body(draft, block, draft.number(1, 3))
    start = Block(OWN, Pair("self.keep", "keep_"), methods=methods, owner=name)
    start.members = block.members
    start.texts, start.numbers = list(block.members), [Pair("self.count", "count_")]
    _body(draft, start, draft.number(0, 2))
    pub = published(draft, start, Pair("'started_' + self.topic", '"started_" + topic_'))
    start.keeps(*pub)
    more = base.overriding if base is not None else Pair("", "")
    after = base.after if base is not None else Pair("", "")
    initial = draft.number(0, 4)
    inits = [f'{base.name if base else "Node"}(label + "_{label}")', "side_(side)", 'topic_(side_ + "_topic")']
    if draft.chance(30):
        inits[1:] = reversed(inits[1:])  # members are made in the order of their declaration
    draft.define(
        f"class {name}({base.name if base else 'Node'}):\n    def __init__(self, label='n', side={side.py}):\n"
        f"        super().__init__(label + '_{label}')\n        self.keep = []\n        self.side = side\n        self.topic = self.side + '_topic'\n"
        f"        self.count = {initial}\n{block.py(2)}\n{after.py}\n    def start(self):\n{start.py(2)}\n{more.py}{class_methods(methods).py}",
        f"class {name} : public {base.name if base else 'rclcpp::Node'}\n{{\npublic:\n"
        f'  explicit {name}(const std::string & label = "n", const std::string & side = {side.cpp})\n  : {", ".join(inits)}\n  {{\n'
        f"{block.cpp(2)}\n{after.cpp}  }}\n  void start()\n  {{\n{start.cpp(2)}\n  }}\n{more.cpp}\nprivate:\n{class_methods(methods).cpp}\n"
        f"  std::string side_;\n  std::string topic_;\n  int count_ = {initial};\n  std::vector<std::shared_ptr<void>> keep_;\n}};",
    )
    first = ""
    for number_ in range(draft.pick([1, 1, 2])):
        node = draft.fresh("node")
        first = first or node
        given = [Pair(f"'l{number_}'", f'"l{number_}"')]
        given += [text(draft, Block(BY_POINTER, GLOBAL_KEEP, pure=True))] if draft.chance(50) else []
        main.say(
            f"{node} = {name}({', '.join(g.py for g in given)})",
            f"auto {node} = std::make_shared<{name}>({', '.join(g.cpp for g in given)});",
        )
        if draft.chance(70):
            main.say(f"{node}.start()", f"{node}->start();")
    return first


class _Base(NamedTuple):
    name: str
    overriding: Pair
    after: Pair


def _base(draft: Draft) -> _Base:
    """A class of nodes to be derived from: a virtual function that its constructor calls is its own there."""
    draft.use("base")
    name, one, two, kind = draft.fresh("Machine"), draft.word(), draft.word(), message(draft)
    draft.define(
        f"class {name}(Node):\n    def __init__(self, name, space='shop'):\n        super().__init__(name, namespace=space)\n"
        f"        self.early = self.create_publisher({kind.py}, {name}.label(self) + '_early', 10)\n\n"
        f"    def label(self):\n        return {one!r}\n\n    def late(self, n=1):\n"
        f"        self.late_pub = self.create_publisher({kind.py}, self.label() + '_late' + str(n), 10)",
        f"class {name} : public rclcpp::Node\n{{\npublic:\n"
        f'  explicit {name}(const std::string & name, const std::string & space = "shop") : rclcpp::Node(name, space)\n  {{\n'
        f'    early_ = create_publisher<{kind.cpp}>(label() + "_early", 10);\n  }}\n'
        f'  virtual std::string label() const {{ return "{one}"; }}\n'
        f'  void late(int n = 1) {{ late_ = create_publisher<{kind.cpp}>(label() + "_late" + std::to_string(n), 10); }}\n\n'
        f"protected:\n  rclcpp::Publisher<{kind.cpp}>::SharedPtr early_, late_;\n}};",
    )
    overriding = Pair(
        f"\n    def label(self):\n        return {two!r}\n",
        f'  std::string label() const override {{ return "{two}"; }}\n',
    )
    count = number(draft, Block(OWN, GLOBAL_KEEP, pure=True))
    after = Pair(f"        self.late({count.py})\n", f"    late({count.cpp});\n")
    return _Base(name, draft.pick([overriding, Pair("", "")]), draft.pick([after, Pair("", "")]))
