# SPDX-License-Identifier: Apache-2.0
"""Promise: what a program sends is recorded, with the entity, the value and the calls that lead there."""

from __future__ import annotations

from pathlib import Path

from rosward.analysis.attempts import run
from rosward.analysis.read import read_sources
from rosward.domain.compound import External
from rosward.domain.values import Const, Ref
from rosward.effects.sent import SentEffect
from rosward.ros.distro import Distro

PROGRAM = """
import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.node import Node
from example_interfaces.action import Fibonacci
from std_msgs.msg import String
from std_srvs.srv import Trigger

class N(Node):
    def __init__(self):
        super().__init__('n')
        self.pub = self.create_publisher(String, 'topic', 10)
        self.create_subscription(String, 'in', self.on_text, 10)
        self.create_client(Trigger, 'ask').call_async(Trigger.Request())
        self.create_service(Trigger, 'answer', self.on_trigger)
        ActionClient(self, Fibonacci, 'count').send_goal_async(Fibonacci.Goal(order=3))
        self.server = ActionServer(self, Fibonacci, 'count_here', self.on_goal)

    def on_text(self, msg):
        self.say(msg)

    def say(self, msg):
        self.pub.publish(msg)

    async def on_trigger(self, request, response):
        response.message = 'done'
        return response

    def on_goal(self, handle):
        handle.publish_feedback(Fibonacci.Feedback())
        return Fibonacci.Result()

def main():
    rclpy.init()
    rclpy.spin(N())

if __name__ == '__main__':
    main()
"""


def test_each_kind_is_recorded_once(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text(PROGRAM, encoding="utf-8")
    found = read_sources([tmp_path], Distro.JAZZY)
    (done,) = [run(found.library, entry, found.budget) for entry in found.plan.entries]
    sent = done.log.sent

    def told(effect: SentEffect) -> tuple[object, ...]:
        assert isinstance(effect.type, External)
        assert isinstance(effect.value, Ref)
        return effect.kind, effect.name, effect.type.name, effect.place.line

    (node,) = {effect.node for effect in sent}
    assert isinstance(node, Ref)
    assert done.log.count_at(node.address) > 0
    assert {told(effect) for effect in sent} == {
        ("publication", Const("topic"), "std_msgs.msg.String", 23),
        ("request", Const("ask"), "std_srvs.srv.Trigger.Request", 14),
        ("response", Const("answer"), "std_srvs.srv.Trigger.Response", 15),
        ("goal", Const("count"), "example_interfaces.action.Fibonacci.Goal", 16),
        ("feedback", Const("count_here"), "example_interfaces.action.Fibonacci.Feedback", 30),
        ("result", Const("count_here"), "example_interfaces.action.Fibonacci.Result", 17),
    }
    (calls,) = [path for effect, path in sent.items() if effect.kind == "publication"]
    assert [place.line for place in calls][-2:] == [20, 23]
