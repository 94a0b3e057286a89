# SPDX-License-Identifier: Apache-2.0
"""What does a node do where it replaces the methods of the library? In a base class, by an attribute, by a patch of Node.

class Base1(Node):
    def create_publisher(self, msg_type, topic, *args, **kw):
        return super().create_publisher(msg_type, topic + "_o", *args, **kw)

class Robot1(Base1): …                 also what rclpy itself creates goes through it
"""

from __future__ import annotations

from typing import Final

from ..draft import Draft, Scope, Statement, Way
from ..values import condition, word

_PUBLISHER: Final = (
    "def create_publisher(self, msg_type, topic, *args, **kw):\n    return super().create_publisher(msg_type, topic + {w}, *args, **kw)",
    "def create_publisher(self, msg_type, topic, *args, **kw):\n    if topic.startswith('/'):\n        return super().create_publisher(msg_type, topic, *args, **kw)\n"
    "    super().create_publisher(msg_type, 'twin_' + topic.replace('/', '_').replace('~', 't'), *args, **kw)\n"
    "    return super().create_publisher(msg_type, topic, *args, **kw)",
    "def create_publisher(self, *args, **kw):\n    made = super().create_publisher(*args, **kw)\n    self.__dict__.setdefault('made', []).append(made.topic_name)\n    return made",
    "def create_publisher(self, msg_type, topic, qos_profile=10, **kw):\n    self.published = getattr(self, 'published', 0) + 1\n"
    "    if self.published == 2:\n        super().create_publisher(String, 'second_of_all', 10)\n    return super().create_publisher(msg_type, topic, qos_profile, **kw)",
)
_OTHERS: Final = (
    "def create_subscription(self, msg_type, topic, callback, qos_profile, **kw):\n    return super().create_subscription(msg_type, topic, callback, qos_profile, **kw)",
    "def create_subscription(self, msg_type, topic, callback, *args, **kw):\n    def on_message(message):\n        self.create_publisher(String, 'heard', 10)\n        return callback(message)\n"
    "    return super().create_subscription(msg_type, topic, on_message, *args, **kw)",
    "def create_subscription(self, *args, **kw):\n    if {t}:\n        self.create_client(Trigger, 'per_subscription')\n    return super().create_subscription(*args, **kw)",
    "def create_service(self, srv_type, srv_name, callback, **kw):\n    self.create_publisher(String, 'service_made', 10)\n    return super().create_service(srv_type, srv_name, callback, **kw)",
    "def create_service(self, srv_type, srv_name, callback, **kw):\n    return super().create_service(srv_type, srv_name.replace('~/', 'own/'), callback, **kw)",
    "def create_client(self, *args, **kw):\n    kw['srv_name'] = kw.pop('srv_name', None) or args[1]\n    kw['srv_type'] = kw.pop('srv_type', None) or args[0]\n    return super().create_client(**kw)",
    "def declare_parameter(self, name, value=None, *args, **kw):\n    super().declare_parameter(name, value, *args, **kw)\n"
    "    if name.startswith('param'):\n        self.create_publisher(String, 'declared/' + name, 10)\n    return self.get_parameter(name)",
    "def declare_parameter(self, name, value=None, *args, **kw):\n    return super().declare_parameter(name, value + {w} if isinstance(value, str) else value, *args, **kw)",
    "def declare_parameters(self, namespace, parameters, *args, **kw):\n    made = super().declare_parameters(namespace, parameters, *args, **kw)\n"
    "    for each in made:\n        self.create_publisher(String, 'many/' + each.name.replace('.', '_'), 10)\n    return made",
    "def get_parameter(self, name):\n    if not hasattr(self, 'asked'):\n        self.asked = self.create_publisher(String, 'first_asked', 10)\n    return super().get_parameter(name)",
    "def get_name(self):\n    return {w} + '_' + super().get_name()",
    "def create_timer(self, period, callback, *args, **kw):\n    callback()\n    return super().create_timer(period, callback, *args, **kw)",
    "def create_timer(self, *args, **kw):\n    self.create_publisher(String, 'ticking', 10)\n    return super().create_timer(*args, **kw)",
    "def destroy_node(self):\n    self.create_publisher(String, 'last_words', 10)\n    super().destroy_node()",
    "def add_on_set_parameters_callback(self, callback):\n    self.create_publisher(String, 'set_watched', 10)\n    super().add_on_set_parameters_callback(callback)",
    "def get_logger(self):\n    if not hasattr(self, 'logs') and hasattr(self, '_publishers'):\n        self.logs = 'yes'\n    return super().get_logger()",
)
_PATCHES: Final = (
    "_create{n} = Node.create_publisher\n\n\ndef patched{n}(self, msg_type, topic, *args, **kw):\n    return _create{n}(self, msg_type, topic + {w}, *args, **kw)\n\n\nNode.create_publisher = patched{n}",
    "_create{n} = Node.create_service\n\n\ndef patched{n}(self, srv_type, srv_name, *args, **kw):\n    Node.create_publisher(self, String, 'patched_{n}', 10)\n"
    "    return _create{n}(self, srv_type, srv_name, *args, **kw)\n\n\nsetattr(Node, 'create_service', patched{n})",
    "_create{n} = Node.create_subscription\nNode.create_subscription = lambda self, *args, **kw: _create{n}(self, *args, **kw)",
    "_declare{n} = Node.declare_parameter\n\n\ndef patched{n}(self, name, *args, **kw):\n    made = _declare{n}(self, name, *args, **kw)\n    self.patched = getattr(self, 'patched', '') + name[-1:]\n    return made\n\n\n"
    "Node.declare_parameter = patched{n}",
)


def node_base(draft: Draft) -> str:
    """The class that a node of the program is derived from: Node, or one that overrides some of its methods."""
    if not draft.further:
        return "Node"
    if draft.chooser.chance(4):
        draft.used.add("patch of Node")
        text = draft.chooser.pick(_PATCHES).replace("{n}", draft.fresh("")).replace("{w}", word(draft, Scope(), 0))
        draft.define(text)
    if not draft.chooser.chance(25):
        return "Node"
    draft.used.add("overridden method")
    cls = draft.fresh("Base")
    chosen = [draft.chooser.pick(_OTHERS)]
    if draft.chooser.chance(50):
        chosen.append(draft.chooser.pick(_PUBLISHER))
    methods = "\n".join(chosen).replace("{w}", repr("_w")).replace("{t}", condition(draft, Scope(), 0))
    head = "(Node)"
    if draft.chooser.chance(20):
        draft.define(f"class {cls}Over:\n" + _indented(methods))
        draft.define(f"class {cls}({cls}Over, Node):\n    pass")
    else:
        draft.define(f"class {cls}{head}:\n" + _indented(methods))
    return cls


def _indented(text: str) -> str:
    return "\n".join("    " + line for line in text.split("\n"))


def replaced(draft: Draft, scope: Scope, _depth: int) -> None:
    """A method of one node that is replaced by a function, for what comes behind."""
    node, name = scope.node, draft.fresh("over")
    suffix = word(draft, scope, 0)
    scope.add(
        draft.chooser.pick(
            [
                f"{name} = {node}.create_publisher\n{node}.create_publisher = lambda kind, topic, *args, **kw: {name}(kind, topic + {suffix}, *args, **kw)\n"
                f"{node}.create_publisher(String, {name!r}, 10)",
                f"{name} = {node}.create_subscription\n\ndef {name}_sub(*args, **kw):\n    {node}.create_publisher(String, {name!r}, 10)\n    return {name}(*args, **kw)\n\n"
                f"{node}.create_subscription = {name}_sub\n{node}.create_subscription(String, {suffix}, print, 10)",
                f"{name} = {node}.create_client\nsetattr({node}, 'create_client', lambda *args: {name}(*args))\n{node}.create_client(Trigger, {suffix})",
                f"{name} = {node}.declare_parameter\n{node}.declare_parameter = lambda n, v=None: {name}(n, v or 'given')\n"
                f"{node}.create_publisher(String, {node}.declare_parameter({name!r}, {suffix}).value, 10)\ndel {node}.declare_parameter",
            ]
        )
    )


WAYS: Final[tuple[Way, ...]] = ()
STATEMENTS: Final[tuple[Statement, ...]] = (replaced,)
