# SPDX-License-Identifier: Apache-2.0
# mypy: disable-error-code="arg-type"
"""Promise: a parameter file gives a node what the real rcl and rclpy (kilted) give it, and is refused where they refuse it."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, NamedTuple

import pytest

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
rclpy = pytest.importorskip("rclpy")
Node = pytest.importorskip("rclpy.node").Node

from rosward.deployment.parameter_files import read_parameter_file  # noqa: E402
from rosward.domain.compound import Tuple  # noqa: E402
from rosward.domain.values import Const, Value  # noqa: E402
from rosward.effects.configuration import Given  # noqa: E402
from rosward.naming.command_line import given_to  # noqa: E402
from rosward.ros.arguments import parse_parameter_rule  # noqa: E402


def of(key: str, body: str) -> str:
    """A file with the parameters `body` of one key."""
    return f"{key}:\n  ros__parameters:\n" + "".join(f"    {line}\n" for line in body.splitlines())


class Run(NamedTuple):
    """A command line, its files and rules in their order, and the node that it starts."""

    words: tuple[str, ...]
    name: str = "node"
    namespace: str = ""


KEYS = """
node /node * ** /* /** /**/node **/node /*/node */node /*/* */* /ns/node ns/node /ns/* ns/* ns/** /ns/** /ns/*/node /*/ns/node
/**/ns/node /** /**/* other /other ns /ns / // /ns//node ns/ /ns/ 1 1/node n-s/node no-de no*de /n*/node /***/node *** node/node /a/b/c/node
a/b/c/node /a/**/node /a/**/c/node /a/*/c/node /a/*/node /**/b/**/node ä "" ~ ros__parameters ros__parameters_x
""".split()  # noqa: SIM905
NODES = (("node", ""), ("node", "ns"), ("node", "/a/b/c"))

VALUES = r"""
1 -1 +5 010 08 0x1F 1_000 1. .5 1.5 5e3 1e400 1e-400 9223372036854775808 inf nan .inf -.inf .nan true tRUE yes
y Y on off N no null ~ hello "5" '5' !!str\x205 !!int\x205 !x\x205 "" '' [] [1,2] [1,2.0] [true,yes] [a,b]
["1",'2'] [1,"2"] [[1,2],[3]] [[1,2]] [1,[2]] {} {a:\x201} [{a:\x201}] [1,{a:\x202}] [1,{a:\x202,b:\x203}]
&a\x205 *a 1\x20#c |\n\x20\x20\x20\x20\x20\x20two\n\x20\x20\x20\x20\x20\x20lines
>-\n\x20\x20\x20\x20\x20\x20folded \n\x20\x20\x20\x20-\x201\n\x20\x20\x20\x20-\x202
\n\x20\x20\x20\x20-\x201\n\x20\x20\x20\x20-\x20a \n\x20\x20\x20\x20-\x20- - x: a:\x20b @a %a `a "a [1 {a ?
?\x20a a:b a,b é "\x41\n" 'it''s' [,] [1,] ,a !!binary\x20aGk= !!float\x201 2001-12-14 1:30 0b11 0o17 <<:\x201
ros__parameters
""".split()  # noqa: SIM905

TEXTS = {
    "empty": "",
    "comment": "# nothing\n",
    "scalar": "hello\n",
    "list": "- a\n- b\n",
    "null node": "node:\n",
    "null parameters": "node:\n  ros__parameters:\n",
    "empty parameters": "node:\n  ros__parameters: {}\n",
    "no parameters key": "node:\n  x: 1\n",
    "parameters at the top": "ros__parameters:\n  x: 1\n",
    "levels": "a:\n  b:\n    c:\n      node:\n        ros__parameters:\n          x: 1\n    node:\n      ros__parameters:\n        y: 2\n",
    "levels with slashes": "/a:\n  b/c:\n    node:\n      ros__parameters:\n        x: 1\n  node:\n    ros__parameters:\n      y: 2\n",
    "slash after slash": "/a:\n  /b:\n    node:\n      ros__parameters:\n        x: 1\n",
    "slash behind": "/a/b/c/:\n  node:\n    ros__parameters:\n      x: 1\n",
    "wildcard above": "/**:\n  node:\n    ros__parameters:\n      x: 1\n  c:\n    node:\n      ros__parameters:\n        x: 2\n",
    "wildcard below": "/a:\n  '**':\n    ros__parameters:\n      x: 1\n",
    "several nodes": of("/**", "x: 1\ny: 1") + of("node", "x: 2") + of("/a/b/c/node", "x: 3"),
    "the order decides": of("/a/b/c/node", "x: 3") + of("node", "x: 2") + of("/**", "x: 1\ny: 1"),
    "same key twice": of("node", "x: 1\ny: 1") + of("node", "x: 2"),
    "two forms of a key": of("node", "x: 1\ny: 1") + of("/node", "x: 2"),
    "same key, other type": of("node", "x: hello") + of("node", "x: 2"),
    "same key, other list": of("node", "x: [1, 2]") + of("node", "x: [a]"),
    "parameter twice": of("node", "x: 1\nx: 2\ny: a\ny: 1\nz: 1.5\nz: 2"),
    "nested": of("/**", "a:\n  b:\n    c: 1\n    d: [x, y]\n  e: true\nf: 2"),
    "value, then mapping": of("/**", "a: 1\na: {b: x}\nc: 3"),
    "mapping, then value": of("/**", "a: {b: x}\na: 1"),
    "dots in nested": of("/**", "a.b: {c.d: 1, e: 2}"),
    "slashes in names": of("/**", "/a/b: 1\nqos_overrides./tf.publisher.depth: 5"),
    "empty mapping": of("/**", "a: {}"),
    "after an empty mapping": of("/**", "a: {}\nb: 1"),
    "empty mapping below": of("/**", "a:\n  b: {}\n  c: 1"),
    "after an empty mapping below": of("/**", "a:\n  b: {}\nc: 1\nd: 2"),
    "list of mappings": of("/**", "a:\n  - b: 1\n    c: 2\n"),
    "list of lists": of("/**", "a: [[1], 2]\nb: 3"),
    "key after a list of lists": of("/**", "a: [[1], b, 2]\nc: 3"),
    "beside the parameters": "/a:\n  ros__parameters:\n    x: 1\n  b/c/node:\n    ros__parameters:\n      y: 1\nnode:\n  ros__parameters: {z: 1}\n",
    "beside the parameters, deep": "a:\n  b:\n    ros__parameters: {x: 1}\n    c:\n      node: {ros__parameters: {y: 1, n: {m: 1}}}\n"
    + of("node", "z: 1"),
    "documents": of("node", "x: 1") + "---\n" + of("node", "y: 2"),
    "documents of other nodes": "a:\n  b:\n" + "    c:\n      node:\n        ros__parameters: {x: 1}\n---\n" + of("/a/b/c/node", "y: 2"),
    "directive": "%YAML 1.1\n---\n" + of("node", "x: 1"),
    "directive of another version": "%YAML 1.2\n---\n" + of("node", "x: 1"),
    "anchor": of("/**", "a: &x 1\nb: 2"),
    "alias": of("/**", "a: &x 1\nb: *x"),
    "merge": "base: &b\n  ros__parameters: {x: 1}\nnode:\n  <<: *b\n",
    "tab": "node:\n\tros__parameters:\n\t\tx: 1\n",
    "not closed": "node: {ros__parameters: {x: 1}\n",
    "flow": "{/**: {ros__parameters: {x: 1, y: [a, b]}}}",
    "json": '{"/**": {"ros__parameters": {"x": 1, "y": ["a", "b"]}}}',
    "quoted keys": "'/**':\n  \"ros__parameters\":\n    'x': 1\n",
    "number as key": of("/**", "1: 2\ntrue: 3"),
    "list as key": of("/**", "[a]: 2"),
    "empty key": of("/**", '"": 2'),
    "null key": of("/**", "? \n: 2"),
    "parameters twice": "node:\n  ros__parameters: {x: 1}\n  ros__parameters: {y: 1}\n",
    "parameters in parameters": "node:\n  ros__parameters:\n    ros__parameters:\n      x: 1\n",
    "bom": "\ufeff" + of("/**", "x: 1"),
    "crlf": of("/**", "x: 1\ny: a").replace("\n", "\r\n"),
    "no end of line": of("/**", "x: 1").rstrip(),
    "simulated time": of("/**", "use_sim_time: true\nx: 1"),
    "deep": "/**:\n  ros__parameters:\n" + "".join("  " * n + f"    k{n}:\n" for n in range(30)) + "  " * 30 + "    x: 1\n",
    "top mapping in a list": "- node:\n    ros__parameters: {x: 1}\n",
    "list before parameters": "node: [1]\n",
    "value before parameters": of("a", "x: 1") + "node: 1\n",
    "mapping without key": "/**:\n  ros__parameters:\n    - a: 1\n",
}  # fmt: skip

FIRST, SECOND = of("/**", "x: 1\ny: a\nz: [1]"), of("node", "x: 2\nw: true")
LINES: dict[str, Run] = {
    "file, then rule": Run(("--params-file", FIRST, "-p", "x:=5")),
    "rule, then file": Run(("-p", "x:=5", "--params-file", FIRST)),
    "rule of another type": Run(("--params-file", FIRST, "-p", "x:=hello")),
    "rule before, of another type": Run(("-p", "x:=true", "--params-file", FIRST)),
    "rule for the node": Run(("-p", "node:x:=5", "--params-file", FIRST, "-p", "x:=6")),
    "two files": Run(("--params-file", FIRST, "--params-file", SECOND)),
    "two files, the other way": Run(("--params-file", SECOND, "--params-file", FIRST)),
    "two files and rules": Run(("-p", "w:=1", "--params-file", SECOND, "-p", "y:=b", "--params-file", FIRST)),
    "file twice": Run(("--params-file", FIRST, "--params-file", FIRST)),
    "node under another name": Run(("--params-file", SECOND, "-r", "__node:=other"), "other"),
    "simulated time by rule": Run(("--params-file", of("/**", "use_sim_time: false"), "-p", "use_sim_time:=true")),
    "nested and dotted in two files": Run(("--params-file", of("/**", "a: {b: 1}"), "--params-file", of("/**", "a.b: 2"))),
    "nested and a rule": Run(("--params-file", of("/**", "a: {b: 1}"), "-p", "a.b:=2")),
}  # fmt: skip

NESTED: dict[str, Run] = {
    "nested and dotted": Run(("--params-file", of("/**", "a.b: 1\na:\n  b: x\n  c: 2\na.c: 3"))),
    "twice": Run(("--params-file", of("/**", "a: {b: 1}\na: {b: x, c: 2}"))),
    "in two files": Run(("--params-file", of("/**", "a: {b: x}"), "--params-file", of("/**", "a: {b: 1}"))),
    "in two files and a rule": Run(
        ("--params-file", of("/**", "a: {b: 1}"), "--params-file", of("/**", "a: {b: 2}"), "-p", "a.b:=3")
    ),
    "dotted, then nested": Run(("--params-file", of("/**", "a.b: 1"), "--params-file", of("/**", "a: {b: x}"))),
}


@pytest.mark.parametrize("key", KEYS)
@pytest.mark.parametrize("node", NODES, ids=repr)
def test_keys(key: str, node: tuple[str, str], tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    compare(Run(("--params-file", of(f'"{key}"' if key != '""' else key, "x: 1")), *node), tmp_path)
    capfd.readouterr()


@pytest.mark.parametrize("value", [v.replace(r"\x20", " ").replace(r"\n", "\n") for v in VALUES], ids=repr)
def test_values(value: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    compare(Run(("--params-file", f"/**:\n  ros__parameters:\n    x: {value}\n    y: 1\n")), tmp_path)
    capfd.readouterr()


@pytest.mark.parametrize("what", TEXTS)
@pytest.mark.parametrize("node", NODES[::2], ids=repr)
def test_files(what: str, node: tuple[str, str], tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    compare(Run(("--params-file", TEXTS[what]), *node), tmp_path)
    capfd.readouterr()


@pytest.mark.parametrize("what", LINES)
def test_command_lines(what: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    compare(LINES[what], tmp_path)
    capfd.readouterr()


@pytest.mark.parametrize("what", NESTED)
def test_nested_names(what: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """A nested name begins an entry of its own; a plain one joins the first entry of its name; the last entry holds."""
    compare(NESTED[what], tmp_path)
    capfd.readouterr()


def compare(run: Run, folder: Path) -> None:
    """Start the real node; what it is given must be what the files and rules say."""
    words, rows, refused = ours(run, folder)
    fqn = f"/{run.namespace.strip('/')}/{run.name}".replace("//", "/")
    context = rclpy.Context()
    try:
        try:
            rclpy.init(args=["program", "--ros-args", *words], context=context)
        except Exception:
            assert refused
            return
        assert not refused
        node = Node(run.name, namespace=run.namespace, context=context)
        try:
            real = declared(node)
        finally:
            node.destroy_node()
    finally:
        context.try_shutdown()
    assert repr({name: plain(value) for name, value in sorted(given_to(fqn, rows).items())}) == repr(real)


def ours(run: Run, folder: Path) -> tuple[list[str], list[Given], bool]:
    """The words with each text written to a file, what we read of them, and whether anything is refused."""
    words: list[str] = []
    rows: list[Given] = []
    refused = False
    for number, (flag, word) in enumerate(zip(run.words[::2], run.words[1::2], strict=True)):
        if flag == "--params-file":
            path = folder / f"{number}.yaml"
            path.write_text(word, encoding="utf-8", newline="")
            given, findings = read_parameter_file(word, path.name)
            assert all(finding.code == "RW317" and finding.place.line for finding in findings)
            rows += given
            refused |= bool(findings)
            words += [flag, str(path)]
            continue
        if flag == "-p":
            rule = parse_parameter_rule(word)
            rows.append(Given(rule.node, rule.name, Const(rule.value.value)))
        words += [flag, word]
    return words, rows, refused


def declared(node: Any) -> dict[str, object]:
    """What declare_parameter gives for each parameter that was set from outside."""
    found: dict[str, object] = {}
    for name in sorted(node._parameter_overrides):
        if node.has_parameter(name):
            value = node.get_parameter(name).value
        else:
            value = node.declare_parameter(name, descriptor=dynamic()).value
        found[name] = list(value) if hasattr(value, "typecode") else value
    return found


def dynamic() -> Any:
    """A description that lets a parameter have any type."""
    return pytest.importorskip("rcl_interfaces.msg").ParameterDescriptor(dynamic_typing=True)


def plain(value: Value) -> object:
    """A value as Python has it; the empty list sets a parameter to nothing."""
    if isinstance(value, Tuple):
        return [plain(item) for item in value.items] or None
    assert isinstance(value, Const)
    return value.value
