# SPDX-License-Identifier: Apache-2.0
"""Which functions and classes does a body use to create something? Functions that take a node, helpers that hold one, templates."""

from __future__ import annotations

import re
from typing import Final

from .draft import BY_MEMBER, BY_POINTER, BY_REFERENCE, GLOBAL_KEEP, OWN, Block, Draft, NodeName, Pair, Statement
from .statements import message, statements
from .values import name_of, number, text, words

_TOPIC: Final = Pair("topic", "topic")
_PREFIX: Final = Pair("self.prefix", "prefix_")


def function(draft: Draft, block: Block, depth: int) -> None:
    """A function that takes a node and creates."""
    name, given, word = draft.fresh("setup"), text(draft, block), draft.word()
    node, head, argument = _taken(draft, block)
    body = Block(node, GLOBAL_KEEP)
    body.texts, body.numbers = [_TOPIC, Pair("more", "more")], [Pair("n", "n")]
    body.local = ["topic", "more", "n"]
    if draft.chance(30):
        body.say("if n == 4:\n    return", "if (n == 4) {\n  return;\n}")
    statements(draft, body, depth + 1, draft.number(0, 1))
    said = body.cpp()
    if head.startswith("template"):
        said = re.sub(r"\bnode\.(\w+)<", r"node.template \1<", said)
    draft.define(
        f"def {name}(node, topic, n=2, more={word!r}):\n{body.py()}",
        f'{head.replace("NAME", name)} const std::string & topic, int n = 2, const std::string & more = "{word}")\n{{\n{said}\n}}',
    )
    further = [number(draft, block)] if draft.chance(50) else []
    block.say(
        f"{name}({', '.join([block.node.py, given.py, *(f.py for f in further)])})",
        f"{name}({', '.join([argument, given.cpp, *(f.cpp for f in further)])});",
    )


def _taken(draft: Draft, block: Block) -> tuple[NodeName, str, str]:
    """How a function takes a node: what its body calls it, the beginning of its head, what it is given."""
    ways = [
        (BY_REFERENCE, "void NAME(rclcpp::Node & node,", block.node.reference),
        (BY_POINTER, "static void NAME(rclcpp::Node * node,", block.node.raw),
        (BY_REFERENCE, "template<typename NodeT>\nvoid NAME(NodeT & node,", block.node.reference),
    ]
    if block.node is OWN and not block.constructing:  # there has to be a shared pointer
        ways.append((BY_POINTER, "void NAME(rclcpp::Node::SharedPtr node,", "shared_from_this()"))
    return draft.pick(ways)


def recursive(draft: Draft, block: Block, depth: int) -> None:
    """A function that calls itself."""
    name, given, count = draft.fresh("tree"), text(draft, block), draft.number(1, 3)
    kind = message(draft)
    draft.define(
        f"def {name}(node, topic, n):\n    if n == 0:\n        return\n    kept.append(node.create_publisher({kind.py}, topic + str(n), 10))\n"
        f"    {name}(node, topic + '_' + str(n), n - 1)",
        f"void {name}(rclcpp::Node & node, const std::string & topic, int n)\n{{\n  if (n == 0) {{\n    return;\n  }}\n"
        f"  kept.push_back(node.create_publisher<{kind.cpp}>(topic + std::to_string(n), 10));\n"
        f'  {name}(node, topic + "_" + std::to_string(n), n - 1);\n}}',
    )
    block.say(f"{name}({block.node.py}, {given.py}, {count})", f"{name}({block.node.reference}, {given.cpp}, {count});")


def typed_function(draft: Draft, block: Block, depth: int) -> None:
    """A function template: in Python the type is an argument."""
    name, given, kind = draft.fresh("advertise"), text(draft, block), message(draft)
    draft.define(
        f"def {name}(kind, node, topic):\n    return node.create_publisher(kind, topic + '_typed', 10)",
        f"template<typename M>\nstd::shared_ptr<rclcpp::Publisher<M>> {name}(rclcpp::Node & node, const std::string & topic)\n{{\n"
        '  return node.create_publisher<M>(topic + "_typed", 10);\n}',
    )
    for each in (kind, message(draft)):
        block.keeps(
            f"{name}({each.py}, {block.node.py}, {given.py})",
            f"{name}<{each.cpp}>({block.node.reference}, {given.cpp})",
        )


def typed_class(draft: Draft, block: Block, depth: int) -> None:
    """A class template that relays."""
    name, given, kind, made = draft.fresh("Relay"), text(draft, block), message(draft), draft.fresh("v")
    draft.define(
        f"class {name}:\n    def __init__(self, kind, node, topic):\n        self.pub = node.create_publisher(kind, topic + '_out', 10)\n"
        f"        self.sub = node.create_subscription(kind, topic + '_in', lambda msg: self.pub.publish(msg), 10)",
        f"template<class M>\nclass {name}\n{{\npublic:\n  {name}(rclcpp::Node * node, const std::string & topic)\n"
        f'  : pub_(node->create_publisher<M>(topic + "_out", 10))\n  {{\n'
        f'    sub_ = node->create_subscription<M>(topic + "_in", 10, [this](typename M::ConstSharedPtr msg) {{ pub_->publish(*msg); }});\n  }}\n\n'
        f"private:\n  typename rclcpp::Publisher<M>::SharedPtr pub_;\n  typename rclcpp::Subscription<M>::SharedPtr sub_;\n}};",
    )
    block.say(
        f"{made} = {name}({kind.py}, {block.node.py}, {given.py})",
        f"auto {made} = std::make_shared<{name}<{kind.cpp}>>({block.node.raw}, {given.cpp});",
    )
    block.keeps(made, made)


def helper(draft: Draft, block: Block, depth: int) -> None:
    """An object that holds a pointer to the node; its methods create."""
    name, made, given = draft.fresh("Helper"), draft.fresh("v"), text(draft, block)
    methods: list[Pair] = []
    start = Block(BY_MEMBER, Pair("self.keep", "keep_"), methods=methods, owner=name)
    start.members = [_PREFIX]
    start.texts, start.numbers = [_PREFIX, _TOPIC], [Pair("self.count", "count_")]
    start.local = ["topic"]
    statements(draft, start, depth + 1, draft.number(0, 1))
    draft.define(
        f"class {name}:\n    def __init__(self, node, prefix='unset', count=1):\n        self.node = node\n        self.prefix = prefix + '_h'\n"
        f"        self.count = count\n        self.keep = []\n\n    def start(self, topic):\n        self.count += 1\n{start.py(2)}\n{class_methods(methods).py}",
        f"class {name}\n{{\npublic:\n"
        f'  explicit {name}(rclcpp::Node * node, const std::string & prefix = "unset", int count = 1)\n'
        f'  : node_(node), prefix_(prefix + "_h"), count_(count) {{}}\n'
        f"  void start(const std::string & topic)\n  {{\n    count_++;\n{start.cpp(2)}\n  }}\n\nprivate:\n{class_methods(methods).cpp}\n"
        f"  rclcpp::Node * node_;\n  std::string prefix_;\n  int count_;\n  std::vector<std::shared_ptr<void>> keep_;\n}};",
    )
    arguments = [given, number(draft, block)][: draft.number(0, 2)]
    block.say(
        f"{made} = {name}({', '.join([block.node.py, *(a.py for a in arguments)])})",
        f"auto {made} = std::make_shared<{name}>({', '.join([block.node.raw, *(a.cpp for a in arguments)])});",
    )
    block.keeps(made, made)
    for _ in range(draft.number(1, 2)):
        topic = text(draft, block)
        block.say(f"{made}.start({topic.py})", f"{made}->start({topic.cpp});")


def virtual(draft: Draft, block: Block, depth: int) -> None:
    """A list of objects of several classes: the methods of the right one run."""
    base, one, two = draft.fresh("Part"), draft.fresh("Part"), draft.fresh("Part")
    first, second, plain = draft.word(), draft.word(), draft.word()
    kind = message(draft)
    draft.define(
        f"class {base}:\n    def topic(self):\n        return 'no'\n\n    def plain(self):\n        return {plain!r}\n\n"
        f"    def setup(self, node):\n        kept.append(node.create_publisher({kind.py}, self.topic() + '_' + {base}.plain(self), 10))\n\n\n"
        f"class {one}({base}):\n    def topic(self):\n        return {first!r}\n\n    def plain(self):\n        return 'hidden'\n\n\n"
        f"class {two}({one}):\n    def __init__(self, more):\n        self.more = more\n\n"
        f"    def topic(self):\n        return super().topic() + '_' + self.more\n\n"
        f"    def setup(self, node):\n        super().setup(node)\n        kept.append(node.create_client(Trigger, {second!r} + self.plain()))",
        f"class {base}\n{{\npublic:\n  virtual ~{base}() = default;\n  virtual std::string topic() const = 0;\n"
        f'  std::string plain() const {{ return "{plain}"; }}\n  virtual void setup(rclcpp::Node & node)\n  {{\n'
        f'    kept.push_back(node.create_publisher<{kind.cpp}>(topic() + "_" + plain(), 10));\n  }}\n}};\n\n'
        f'class {one} : public {base}\n{{\npublic:\n  std::string topic() const override {{ return "{first}"; }}\n'
        f'  std::string plain() const {{ return "hidden"; }}\n}};\n\n'
        f"class {two} : public {one}\n{{\npublic:\n  explicit {two}(std::string more) : more_(std::move(more)) {{}}\n"
        f'  std::string topic() const override {{ return {one}::topic() + "_" + more_; }}\n'
        f"  void setup(rclcpp::Node & node) override\n  {{\n    {base}::setup(node);\n"
        f'    kept.push_back(node.create_client<std_srvs::srv::Trigger>("{second}" + plain()));\n  }}\n\nprivate:\n  std::string more_;\n}};',
    )
    given, parts = text(draft, block), draft.fresh("v")
    pointer = draft.pick(["unique", "shared"])
    block.say(
        f"{parts} = [{one}(), {two}({given.py})]\nfor part in {parts}:\n    part.setup({block.node.py})",
        f"std::vector<std::{pointer}_ptr<{base}>> {parts};\n{parts}.push_back(std::make_{pointer}<{one}>());\n"
        f"{parts}.push_back(std::make_{pointer}<{two}>({given.cpp}));\nfor (const auto & part : {parts}) {{\n"
        f"  part->setup({block.node.reference});\n}}",
    )


def registry(draft: Draft, block: Block, depth: int) -> None:
    """What is written into a global list, and read from it."""
    name, add, items = draft.fresh("registry"), draft.fresh("enlist"), words(draft, block)
    kind = message(draft)
    draft.define(
        f"{name} = []\n\n\ndef {add}(items):\n    for item in items:\n        {name}.append('r_' + item)",
        f"std::vector<std::string> {name};\n\nvoid {add}(const std::vector<std::string> & items)\n{{\n"
        f'  for (const auto & item : items) {{\n    {name}.push_back("r_" + item);\n  }}\n}}',
    )
    block.say(
        f"{add}({items.py})\nfor entry in list({name}):\n    kept.append({block.node.py}.create_publisher({kind.py}, entry, 10))",
        f"{add}({items.cpp});\nfor (size_t i = 0; i < {name}.size(); i++) {{\n"
        f"  kept.push_back({block.node.call}create_publisher<{kind.cpp}>({name}[i], 10));\n}}",
    )


def dispatch(draft: Draft, block: Block, depth: int) -> None:
    """A map from words to functions."""
    table, word, given = draft.fresh("v"), draft.pick(["one", "two"]), text(draft, block)
    kind = message(draft)
    block.say(
        f"{table} = {{}}\n{table}['one'] = lambda x: x + '_1'\n{table}['two'] = lambda x: 'two_' + x\n"
        f"kept.append({block.node.py}.create_publisher({kind.py}, {table}[{word!r}]({given.py}), 10))",
        f"std::map<std::string, std::function<std::string(const std::string &)>> {table};\n"
        f'{table}["one"] = [](const std::string & x) {{ return x + "_1"; }};\n{table}["two"] = [](const std::string & x) {{ return "two_" + x; }};\n'
        f'kept.push_back({block.node.call}create_publisher<{kind.cpp}>({table}["{word}"]({given.cpp}), 10));',
    )


def optional_handle(draft: Draft, block: Block, depth: int) -> None:
    """A pointer that is null at first."""
    variable, name = draft.fresh("v"), name_of(draft, block)
    kind = message(draft)
    block.say(
        f"{variable} = None\nif {variable} is None:\n    {variable} = {block.node.py}.create_publisher({kind.py}, {name.py}, 10)\n"
        f"if not {variable}:\n    {block.node.py}.create_publisher({kind.py}, 'never', 10)",
        f"rclcpp::Publisher<{kind.cpp}>::SharedPtr {variable};\nif (!{variable}) {{\n"
        f"  {variable} = {block.node.call}create_publisher<{kind.cpp}>({name.cpp}, 10);\n}}\n"
        f'if ({variable} == nullptr) {{\n  {block.node.call}create_publisher<{kind.cpp}>("never", 10);\n}}',
    )


def class_methods(methods: list[Pair]) -> Pair:
    """The methods of a class, as they stand in it."""
    return Pair(
        "".join("\n" + "\n".join("    " + line for line in method.py.splitlines()) + "\n" for method in methods),
        "\n".join("\n".join("  " + line for line in method.cpp.splitlines()) for method in methods),
    )


SHAPES: Final[tuple[Statement, ...]] = (
    *(
        function,
        function,
        recursive,
        typed_function,
        typed_class,
        helper,
        helper,
        virtual,
        registry,
        dispatch,
        optional_handle,
    ),
)
