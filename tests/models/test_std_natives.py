# SPDX-License-Identifier: Apache-2.0
"""Natives of the standard library: what they compute on constants, and what they keep of partly known values."""

from __future__ import annotations

import time

import pytest

from models.fake_std import TABLES, FakeMachine
from rosward.domain.choice import join, join_all, options
from rosward.domain.compound import Native, Partial, Range, Tuple
from rosward.domain.heap import Obj
from rosward.domain.text import concat
from rosward.domain.unknown import Cause, Origin
from rosward.domain.values import NONE, UNBOUND, Const, Text, Value
from rosward.models.native import Machine
from rosward.models.python.std.pattern_cost import work
from rosward.models.python.std.support import from_plain, to_plain


@pytest.fixture
def machine() -> FakeMachine:
    return FakeMachine()


def text(machine: FakeMachine, *parts: str) -> Value:
    """A text in which `*` is unknown."""
    hole = machine.unknown(Cause.PARAMETER, "name", "str")
    return concat([hole if p == "*" else Const(p) for p in parts])


def test_fake_is_a_machine(machine: FakeMachine) -> None:
    offered: Machine = machine
    assert offered.place


def test_each_name_stands_in_one_table() -> None:
    names = [name for table in TABLES for name in table]
    assert len(names) == len(set(names))


@pytest.mark.parametrize(
    ("name", "parts", "result"),
    [
        ("join", ["/a", "b", "c.yaml"], "/a/b/c.yaml"),
        ("join", ["/a", "/b"], "/b"),
        ("join", ["", "b"], "b"),
        ("join", ["/a/", "b"], "/a/b"),
        ("basename", ["/a/b.py"], "b.py"),
        ("dirname", ["/a/b.py"], "/a"),
        ("dirname", ["/a"], "/"),
        ("dirname", ["a"], ""),
        ("normpath", ["/a/../b//c/."], "/b/c"),
        ("abspath", ["/a/./b"], "/a/b"),
    ],
)
def test_paths_of_constants(machine: FakeMachine, name: str, parts: list[str], result: str) -> None:
    assert machine.plain(machine.native(f"os.path.{name}", *map(Const, parts))) == result


def test_paths_keep_what_is_known(machine: FakeMachine) -> None:
    share = text(machine, "*")
    path = machine.native("os.path.join", share, Const("config"), Const("a.yaml"))
    assert machine.plain(path) == "*/config/a.yaml"
    assert machine.plain(machine.native("os.path.basename", path)) == "a.yaml"
    assert machine.plain(machine.native("os.path.dirname", path)) == "*/config"
    assert machine.plain(machine.native("os.path.splitext", path)) == ("*/config/a", ".yaml")
    assert machine.plain(machine.native("os.path.abspath", Const("x"))) == "*/x"
    assert machine.plain(machine.native("os.path.expanduser", Const("~/x"))) == "*/x"
    assert machine.plain(machine.native("os.path.splitext", text(machine, "/a/", "*"))) == ("/a/*", "?")


def test_an_unknown_second_part_may_be_absolute(machine: FakeMachine) -> None:
    assert machine.plain(machine.native("os.path.join", Const("/a"), text(machine, "*"))) == {"/a/*", "?"}


def test_origins_pass_through_paths(machine: FakeMachine) -> None:
    origin = Origin("environment variable", "HOME")
    path = machine.native("os.path.join", Const("/h", frozenset({origin})), Const("b"))
    assert path == Const("/h/b", frozenset({origin}))
    assert machine.native("os.path.dirname", path) == Const("/h", frozenset({origin}))


def test_paths_normalise(machine: FakeMachine) -> None:
    assert machine.plain(machine.native("pathlib._join", Tuple((Const("a/"), Const("./b"))))) == "a/b"
    assert machine.plain(machine.native("pathlib._join", Tuple(()))) == "."


def test_programs_that_are_started_are_told(machine: FakeMachine) -> None:
    machine.native("os.system", Const("ros2 run demo talker"))
    machine.native(
        "subprocess._launches", machine.new_list([Const("/usr/bin/ros2"), Const("launch"), text(machine, "*")])
    )
    machine.native("subprocess._launches", Const("ls -l"))
    machine.native("os.system", concat([Const("python3 "), text(machine, "*"), Const("/x.py")]))
    assert [code for code, _ in machine.findings] == ["RW210"] * 3
    assert "`/usr/bin/ros2 launch *`" in machine.findings[1][1]


def test_exit_ends_the_path(machine: FakeMachine) -> None:
    assert machine.native("sys.exit", Const(3)) is UNBOUND
    assert machine.deaths == [("SystemExit", "3")]


def test_math(machine: FakeMachine) -> None:
    assert machine.native("math.sqrt", join(Const(4), Const(9))) == join(Const(2.0), Const(3.0))
    assert machine.native("math.sqrt", Const(-1)) is UNBOUND
    assert machine.deaths[0][0] == "ValueError"
    assert machine.plain(machine.native("math.floor", machine.unknown(Cause.MESSAGE, "x"))) == "?"
    assert machine.plain(machine.native("math.factorial", Const(10**9))) == "?"
    assert machine.native("math.gcd", Const(12), Const(18)) == Const(6)
    assert machine.native("math.atan2", Const(0), Const(1)) == Const(0.0)


def test_random_choice_is_one_of_them(machine: FakeMachine) -> None:
    assert machine.plain(machine.native("random.choice", machine.new_list([Const("a"), Const("b")]))) == {"a", "b"}
    assert machine.plain(machine.native("random.randint", Const(1), Const(3))) == {1, 2, 3}
    assert machine.plain(machine.native("random.randint", Const(1), Const(300))) == "?"
    made = machine.new_list([Const(1), Const(2)])
    machine.native("random.shuffle", made)
    assert machine.plain(made) == [{1, 2}, {1, 2}]


def test_regular_expressions(machine: FakeMachine) -> None:
    assert machine.native("re._sub", Const("[^a-z]"), Const(0), Const("_"), Const("my robot"), Const(0)) == Const(
        "my_robot"
    )
    found = machine.native("re._find", Const("match"), Const(r"(?P<ns>\w+)/(\d+)"), Const(0), Const("arm/12"))
    spans = {0: [0, 6], 1: [0, 3], 2: [4, 6], "ns": [0, 3]}
    assert machine.plain(found) == {0: "arm/12", "": spans, 1: "arm", 2: "12", "ns": "arm"}
    assert machine.native("re._find", Const("search"), Const("x"), Const(0), Const("abc")) == NONE
    open_end = machine.native(
        "re._find", Const("search"), Const("x"), Const(0), machine.unknown(Cause.FILE, "f", "str")
    )
    assert NONE in options(open_end)
    assert len(options(open_end)) == 2
    assert machine.plain(machine.native("re._split", Const("[,;]"), Const(0), Const("a,b;c"), Const(0))) == [
        "a",
        "b",
        "c",
    ]


@pytest.mark.parametrize(
    "pattern",
    [
        "(a+)+b", "(a|a)*b", "(a*)*", "(?:a{1,9}){1,9}", "a*a*a*a*b", "((a?)+)+", "a?" * 30 + "a" * 30, "(|a)+b",
        "(a|aa)+$", "(?:(?:a{0,50}){0,50}){0,50}b", "(?=(a+)+b)a", "(?<=aa)(a+)+b", "(.*?a){11}b", "((a?){20}){20}",
        "(?P<q>a+)+(?P=q)b", "(a)?(?(1)(a|a)*|a)b", "x" * 2_000,
    ],
)  # fmt: skip
def test_expensive_patterns_are_refused(pattern: str) -> None:
    assert work(pattern, 0, "a" * 100) is None


@pytest.mark.parametrize(
    "pattern",
    [
        r"^/?[a-z_]+/\d+$", "[^a-zA-Z0-9]", r"(\w+)_(\d+)", "a|b", "(a|b)?c", r"\s+", r"(\w+)_(\w+)_(\w+)", "(a)\\1",
        "(?i:FRONT)_(left|right)", "x" * 300, "(?<!a)b", "(?m)^.*$",
    ],
)  # fmt: skip
def test_usual_patterns_are_cheap(pattern: str) -> None:
    assert work(pattern, 0, "front_left/camera_12/" * 4) is not None


def test_what_a_pattern_costs_depends_on_the_text() -> None:
    assert work("(a+)+b", 0, "a" * 100) is None
    assert work("(a+)+b", 0, "front/left" * 10) is not None


def test_ways_are_counted() -> None:
    assert work("b", 0, "aa") == 6  # two searches at each of three positions
    assert work("(?:a|a)b", 0, "a") == 10  # and there are two ways to the `b` behind an `a`
    assert work("a?a?a?a?", 0, "aaaa") == 318


def test_cheap_means_cheap(machine: FakeMachine) -> None:
    start = time.process_time()
    for pattern in ("a*a*a*b", "(a*)(a*)(a*)b", ".*.*.*=", "a{1,50}a{1,50}a{1,50}b"):
        machine.native("re._find", Const("search"), Const(pattern), Const(0), Const("a" * 200))
    assert time.process_time() - start < 5


def test_json_and_yaml_of_constants(machine: FakeMachine) -> None:
    assert machine.plain(machine.native("json.loads", Const('{"a": [1, null, "/x"]}'))) == {"a": [1, None, "/x"]}
    assert machine.plain(machine.native("yaml.safe_load", Const("a:\n  - /scan\n"))) == {"a": ["/scan"]}
    assert machine.native("json.loads", Const("{")) is UNBOUND
    assert machine.deaths[0][0] == "JSONDecodeError"


def test_hostile_data_is_bounded(machine: FakeMachine) -> None:
    bomb = "a: &a [x,x,x,x,x,x,x,x,x]\n" + "".join(
        f"{chr(98 + i)}: &{chr(98 + i)} [{','.join(['*' + chr(97 + i)] * 9)}]\n" for i in range(9)
    )
    start = time.process_time()
    machine.native("yaml.safe_load", Const(bomb))
    machine.native("json.loads", Const("[" * 90_000))
    machine.native("yaml.safe_load", Const("[" * 20_000))
    assert time.process_time() - start < 5


def test_a_file_is_named_in_the_reason(machine: FakeMachine) -> None:
    handle = machine.unknown(Cause.FILE, "robot.yaml")
    assert machine.native("yaml.safe_load", handle) == handle
    assert machine.plain(machine.native("json.dumps", from_plain(machine, {"a": 1}))) == '{"a": 1}'


def test_partial_and_wraps(machine: FakeMachine) -> None:
    function = Native("demo.f")
    made = machine.native("functools.partial", function, Const(1), key=Const(2))
    assert made == Partial(function, (Const(1),), (("key", Const(2)),))
    assert machine.native("functools.partial", made, Const(3), key=Const(4)) == Partial(
        function, (Const(1), Const(3)), (("key", Const(4)),)
    )
    decorator = machine.native("functools.wraps", function)
    assert machine.call(decorator, (Const("wrapper"),)) == Const("wrapper")


def test_itertools(machine: FakeMachine) -> None:
    letters = machine.new_list([Const("a"), Const("b")])
    numbers = Range(Const(0), Const(2), Const(1))
    assert machine.plain(machine.native("itertools.product", letters, numbers)) == [
        ("a", 0),
        ("a", 1),
        ("b", 0),
        ("b", 1),
    ]
    assert machine.plain(machine.native("itertools.permutations", letters)) == [("a", "b"), ("b", "a")]
    assert machine.plain(machine.native("itertools.combinations", letters, Const(2))) == [("a", "b")]
    assert machine.plain(machine.native("itertools.islice", letters, Const(1))) == ["a"]
    assert machine.plain(machine.native("itertools.cycle", letters)) == ["...", {"a", "b"}]
    assert machine.plain(machine.native("itertools.repeat", Const("x"), Const(2))) == ["x", "x"]
    assert machine.plain(machine.native("itertools.zip_longest", letters, Tuple((Const(1),)))) == [
        ("a", 1),
        ("b", None),
    ]
    many = Range(Const(0), Const(500), Const(1))
    assert machine.plain(machine.native("itertools.pairwise", letters)) == [("a", "b")]
    assert machine.plain(machine.native("itertools.permutations", many, Const(40)))  # ends, and soon


def test_reduce(machine: FakeMachine) -> None:
    machine.functions[Native("demo.add")] = lambda a, b: machine.binary("+", a, b)
    items = machine.new_list([Const(1), Const(2), Const(3)])
    assert machine.native("functools.reduce", Native("demo.add"), items) == Const(6)
    assert machine.native("functools.reduce", Native("demo.add"), items, Const(4)) == Const(10)


def test_deepcopy_keeps_sharing(machine: FakeMachine) -> None:
    inner = machine.new_list([Const(1)])
    outer = machine.new_list([inner, inner])
    machine.store_item(inner, Const(0), outer)  # a cycle
    copied = machine.native("copy.deepcopy", outer)
    first, second = machine.iterate(copied).known
    assert first == second != inner
    assert machine.load_item(first, Const(0)) == copied


def test_values_there_and_back(machine: FakeMachine) -> None:
    value = {"a": [1, 2.5, "x", None], "b": {"c": (True,)}}
    assert to_plain(machine, from_plain(machine, value))[0] == value


def declared(machine: FakeMachine, *flags: str, dest: str, action: str = "store", **given: Value) -> Value:
    attrs = {
        "option_strings": Tuple(tuple(map(Const, flags))),
        "dest": Const(dest),
        "_action": Const(action),
        "nargs": NONE,
        "required": Const(False),
        "type": NONE,
        "const": NONE,
        **given,
    }
    return machine.allocate(Obj("instance", NONE, attrs))


def test_known_arguments_are_parsed(machine: FakeMachine) -> None:
    actions = machine.new_list(
        [
            declared(machine, "-t", "--topic", dest="topic"),
            declared(machine, "--rate", dest="rate", type=Native("builtins.int")),
            declared(machine, "--fast", dest="fast", action="store_true"),
            declared(machine, "--more", dest="more", nargs=Const("+")),
            declared(machine, "robot", dest="robot"),
        ]
    )

    def parse(words: str, some: bool = False) -> object:
        given = machine.new_list([Const(w) for w in words.split()])
        return machine.plain(machine.native("argparse._exact", actions, given, Const(some), Const("-")))

    assert parse("--topic /a --rate=3 arm --fast --more x y") == (
        {"topic": "/a", "rate": 3, "fast": True, "more": ["x", "y"], "robot": "arm"},
        [],
    )
    assert parse("arm --other", some=True) == ({"robot": "arm"}, ["--other"])
    assert parse("arm --other") is UNBOUND
    assert parse("--topic") is UNBOUND
    assert [error for error, _ in machine.deaths] == ["SystemExit", "SystemExit"]
    unknown = machine.new_list((), machine.unknown(Cause.ARGUMENT, "sys.argv", "str"))
    assert machine.native("argparse._exact", actions, unknown, Const(False), Const("-")) == NONE


def test_getopt_gives_any_option(machine: FakeMachine) -> None:
    found = machine.native("getopt.getopt", NONE, Const("hn:"), machine.new_list([Const("name=")]))
    assert isinstance(found, Tuple)
    assert machine.plain(found.items[0]) == ["...", ({"-h", "-n", "--name"}, "?")]


def test_varying_values_say_so(machine: FakeMachine) -> None:
    value = machine.native("socket.gethostname")
    assert isinstance(concat([Const("/"), value]), Text)
    assert join_all([value]).reasons[0].cause is Cause.RANDOM  # type: ignore[attr-defined]
