# SPDX-License-Identifier: Apache-2.0
"""What can a body do? It creates entities; what else it does stands in `data` and `flow`. Each statement is said in both languages."""

from __future__ import annotations

from typing import Final

from .draft import Block, Draft, Pair, Statement
from .values import name_of

DEPTH: Final = 2
"""So deep are bodies in bodies."""
_MESSAGES: Final = (
    Pair("String", "std_msgs::msg::String"),
    Pair("Bool", "std_msgs::msg::Bool"),
    Pair("Twist", "geometry_msgs::msg::Twist"),
)
_SERVICES: Final = (Pair("Trigger", "std_srvs::srv::Trigger"), Pair("SetBool", "std_srvs::srv::SetBool"))


def statements(draft: Draft, block: Block, depth: int, count: int) -> None:
    """Some statements, and at least one that creates."""
    for _ in range(count):
        ways = CREATIONS if depth >= DEPTH or draft.chance(40) else draft.statements
        way = draft.pick(ways)
        draft.use(way.__name__)
        way(draft, block, depth)
    publisher(draft, block, depth)


def message(draft: Draft) -> Pair:
    """A type of messages."""
    return draft.pick(_MESSAGES)


def published(draft: Draft, block: Block, name: Pair) -> Pair:
    """The expression that creates a publisher."""
    kind = message(draft)
    qos = draft.pick(
        ["10", "rclcpp::QoS(10)", "rclcpp::SensorDataQoS()", "rclcpp::QoS(rclcpp::KeepLast(1)).transient_local()"]
    )
    return Pair(
        f"{block.node.py}.create_publisher({kind.py}, {name.py}, 10)",
        f"{block.node.call}create_publisher<{kind.cpp}>({name.cpp}, {qos})",
    )


def publisher(draft: Draft, block: Block, depth: int) -> None:
    made = published(draft, block, name_of(draft, block))
    if draft.chance(50):
        block.keeps(*made)
    else:
        variable = draft.fresh("pub")
        block.say(f"{variable} = {made.py}", f"auto {variable} = {made.cpp};\n(void){variable};")


def generic(draft: Draft, block: Block, depth: int) -> None:
    name = name_of(draft, block)
    block.keeps(
        f"{block.node.py}.create_publisher(String, {name.py}, 10)",
        f'{block.node.call}create_generic_publisher({name.cpp}, "std_msgs/msg/String", rclcpp::QoS(10))',
    )


def client(draft: Draft, block: Block, depth: int) -> None:
    kind, name = draft.pick(_SERVICES), name_of(draft, block)
    block.keeps(
        f"{block.node.py}.create_client({kind.py}, {name.py})",
        f"{block.node.call}create_client<{kind.cpp}>({name.cpp})",
    )


def action_client(draft: Draft, block: Block, depth: int) -> None:
    name = name_of(draft, block, prefixes=("", "/", "~/"))
    block.keeps(
        f"ActionClient({block.node.py}, Fibonacci, {name.py})",
        f"rclcpp_action::create_client<test_msgs::action::Fibonacci>({block.node.pointer}, {name.cpp})",
    )


def _called_later(draft: Draft, block: Block, depth: int, parameters: Pair, *, returns: str = "") -> Pair:
    """A callback with a body of its own: the expression for it in both languages."""
    name = draft.fresh("on")
    if block.methods is not None and draft.chance(50):
        inner = Block(block.node, block.keep, methods=block.methods, owner=block.owner)
        inner.members = block.members
        inner.texts += block.members
        statements(draft, inner, depth + 1, draft.number(0, 1))
        block.methods.append(
            Pair(
                f"def {name}(self{parameters.py and ', ' + parameters.py}):\n{inner.py()}{returns and chr(10) + '    ' + returns}",
                f"void {name}({parameters.cpp})\n{{\n{inner.cpp()}\n}}",
            )
        )
        holders = "".join(
            f", std::placeholders::_{n + 1}" for n in range(parameters.cpp.count("&") + parameters.cpp.count("Ptr"))
        )
        return Pair(f"self.{name}", f"std::bind(&{block.owner}::{name}, this{holders})")
    captured = draft.random.sample(block.local, min(len(block.local), draft.number(0, 2)))
    inner = block.nested(captured=captured)
    statements(draft, inner, depth + 1, draft.number(0, 1))
    asked = [parameters.py] if parameters.py else []
    asked += [f"{each}={each}" for each in captured]
    block.say(f"def {name}({', '.join(asked)}):\n{inner.py()}{returns and chr(10) + '    ' + returns}", "")
    capture = ", ".join([block.node.capture, *captured])
    if block.node.capture == "this" and draft.chance(30):
        capture = "="
    return Pair(name, f"[{capture}]({parameters.cpp}) {{\n{inner.cpp()}\n}}")


def subscription(draft: Draft, block: Block, depth: int) -> None:
    kind, name = message(draft), name_of(draft, block)
    form = draft.pick(
        [f"const {kind.cpp} & msg", f"{kind.cpp}::SharedPtr msg", f"const {kind.cpp}::ConstSharedPtr msg"]
    )
    if depth < DEPTH and draft.chance(60):
        heard = _called_later(draft, block, depth, Pair("msg", form))
    else:
        heard = Pair("lambda msg: None", f"[]({form}) {{}}")
    block.keeps(
        f"{block.node.py}.create_subscription({kind.py}, {name.py}, {heard.py}, 10)",
        f"{block.node.call}create_subscription<{kind.cpp}>({name.cpp}, 10, {heard.cpp})",
    )


def service(draft: Draft, block: Block, depth: int) -> None:
    kind, name = draft.pick(_SERVICES), name_of(draft, block)
    form = f"const {kind.cpp}::Request::SharedPtr request, {kind.cpp}::Response::SharedPtr response"
    if depth < DEPTH and draft.chance(60):
        served = _called_later(draft, block, depth, Pair("request, response", form), returns="return response")
    else:
        served = Pair("lambda request, response: response", f"[]({form}) {{}}")
    block.keeps(
        f"{block.node.py}.create_service({kind.py}, {name.py}, {served.py})",
        f"{block.node.call}create_service<{kind.cpp}>({name.cpp}, {served.cpp})",
    )


def timer(draft: Draft, block: Block, depth: int) -> None:
    called = _called_later(draft, block, depth, Pair("", ""))
    period = draft.pick(["std::chrono::milliseconds(100)", "500ms", "1s"])
    block.keeps(
        f"{block.node.py}.create_timer(0.5, {called.py})", f"{block.node.call}create_wall_timer({period}, {called.cpp})"
    )


CREATIONS: Final[tuple[Statement, ...]] = (
    *(publisher, publisher, publisher, subscription, subscription, service, client, action_client, timer, generic),
)
