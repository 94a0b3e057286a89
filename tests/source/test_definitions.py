# SPDX-License-Identifier: Apache-2.0
"""Promise: fields, defaults and constants of interfaces are those that rosidl makes of their files."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.source.definitions import Field, read_definition
from rosward.source.interfaces import InterfaceIndex
from source.trees import manifest, read

MODE = """
# a comment
uint8 FAST=2     # how fast
string<=8 NAME = "left"
byte B=0x01
bool ON=true
float32 HALF=0.5
string note 'it is'
string<=5 short
float64[3] axes
float64[] many
Point[<=4] points
std_msgs/Header header
Header old
char c 7
"""


def test_a_message() -> None:
    found = read_definition(MODE, "mine", "msg", closed=True)
    assert found is not None
    mode = found[""]
    assert mode.constants == {"FAST": 2, "NAME": "left", "B": b"\x01", "ON": True, "HALF": 0.5}
    assert mode.fields == {
        "note": Field("string", "", "it is", False, True),
        "short": Field("string", "", "", False, True),
        "axes": Field("float64", "[3]", None, False, True),
        "many": Field("float64", "[]", None, True, True),
        "points": Field("mine/Point", "[<=4]", None, True, True),
        "header": Field("std_msgs/Header", "", None, False, True),
        "old": Field("std_msgs/Header", "", None, False, True),
        "c": Field("char", "", 7, False, True),
    }


@pytest.mark.parametrize(
    ("text", "kind", "parts"),
    [
        ("int32 a\n---\nint32 b", "srv", {"Request", "Response"}),
        ("---", "srv", {"Request", "Response"}),
        ("int32 a\n---\nint32 b\n---\nint32 c", "action", {"Goal", "Result", "Feedback"}),
    ],
)
def test_parts(text: str, kind: str, parts: set[str]) -> None:
    found = read_definition(text, "mine", kind, closed=True)
    assert found is not None
    assert found.keys() == parts


def test_what_is_no_interface() -> None:
    assert read_definition("int32 a", "mine", "srv", closed=True) is None
    assert read_definition("int32 a\n---\nint32 b", "mine", "msg", closed=True) is None
    assert read_definition("int32 1x", "mine", "msg", closed=True) == {}


def test_what_distros_differ_in_is_not_known() -> None:
    found = read_definition("?string error_msg\n* poses\n* LEVEL=", "mine", "msg", closed=False)
    assert found is not None
    assert not found[""].fields["error_msg"].sure
    assert found[""].fields["poses"].default is None
    assert found[""].constants == {"LEVEL": None}


def test_definitions_of_common_packages() -> None:
    index = InterfaceIndex()
    quaternion = index.definition("geometry_msgs", "msg", "Quaternion")
    assert quaternion is not None
    assert [f.default for f in quaternion.fields.values()] == [0.0, 0.0, 0.0, 1.0]
    response = index.definition("std_srvs", "srv", "Trigger", "Response")
    assert response is not None
    assert list(response.fields) == ["success", "message"]
    assert index.definition("std_srvs", "srv", "Trigger") is None
    assert index.definition("my_msgs", "msg", "Foo") is None


def test_files_of_the_workspace_go_first(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        {
            "std_msgs/package.xml": manifest("std_msgs", "ament_cmake"),
            "std_msgs/msg/String.msg": "string text 'own'",
            "std_msgs/msg/Int8.idl": "module std_msgs {};",
        },
    )
    index = InterfaceIndex(found)
    own = index.definition("std_msgs", "msg", "String")
    assert own is not None
    assert own.fields == {"text": Field("string", "", "own", False, True)}
    assert own.closed
    assert index.definition("std_msgs", "msg", "Int8") is None
    assert index.definition("std_msgs", "msg", "Bool") is None
