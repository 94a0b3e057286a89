# SPDX-License-Identifier: Apache-2.0
"""Promise: a policy has a pattern only where a finding names it, whatever characters the source has in its names."""

from __future__ import annotations

import re
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

from hypothesis import given, settings
from hypothesis import strategies as st
from laws import examples

import rosward
from rosward.outputs.policies.permissions import permissions
from rosward.outputs.policies.policy import policies

UNKNOWN: Final = "socket.gethostname()"
CHARACTERS: Final = "ab/*?[]_~{}"
NAMED: Final = re.compile(r"<(?:topic|service|action)>([^<]*)<|(?: ns| node| path)=\"([^\"]*)\"")
TELLING: Final = ("RW101", "RW102", "RW105")

pieces = st.lists(
    st.one_of(st.text(CHARACTERS, min_size=1, max_size=4).map(repr), st.just(UNKNOWN)), min_size=1, max_size=3
)
names = pieces.map(" + ".join)
words = st.lists(st.one_of(st.sampled_from(("'-r'", "'-p'", "'--enclave'", "'--'")), names), max_size=4)


@st.composite
def programs(draw: st.DrawFn) -> str:
    """A program whose names are put together of odd characters and of what is not known."""
    name, space, topic, service, match, target = (draw(names) for _ in range(6))
    rules = f"['--ros-args', '-r', ({match}) + ':=' + ({target})]" if draw(st.booleans()) else "sys.argv"
    rules += f" + ['--ros-args', {', '.join(draw(words))}]" if draw(st.booleans()) else ""
    name = name if draw(st.booleans()) else "'talker'"
    space = space if draw(st.booleans()) else "'/left'"
    return f"""
import socket
import sys
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import SetBool

rclpy.init(args={rules})
node = Node({name}, namespace={space})
try:
    node.create_publisher(String, {topic}, 10)
except Exception:
    pass
try:
    node.create_client(SetBool, node.declare_parameter('p', {service}).value)
except Exception:
    pass
rclpy.spin(node)
"""


def names_in(text: str) -> list[str]:
    """What a policy or a permission names."""
    return [found[1] or found[2] or "" for found in NAMED.finditer(text)]


@settings(max_examples=examples(0.8), deadline=None)
@given(programs())
def test_a_pattern_has_a_finding_that_names_it(program: str) -> None:
    with TemporaryDirectory() as folder:
        (Path(folder) / "main.py").write_text(program, encoding="utf-8")
        result = rosward.extract(Path(folder))
    told = {f.place.line for f in result.findings if f.code in TELLING}
    granted = "\n".join(policies(result.network).values())
    for text in (granted, *permissions(result.network).values()):
        for name in names_in(text):
            assert not set("?[]") & set(name), name
            assert text is not granted or "*" not in name or UNKNOWN in program, name
    for node in result.network.nodes:
        known = "*" not in node.fqn or node.defined_at.line in told
        assert known, node.fqn
        for entity in node.entities:
            lines = {place.line for place in (*entity.created_at, node.defined_at)}
            assert "*" not in entity.name or lines & told, (entity.name, result.findings)
