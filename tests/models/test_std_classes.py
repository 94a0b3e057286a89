# SPDX-License-Identifier: Apache-2.0
"""Classes made of their fields or members: dataclasses, named tuples, enumerations."""

from __future__ import annotations

import pytest

from models.fake_std import FakeMachine
from rosward.domain.compound import External, Native, Tuple
from rosward.domain.heap import Obj
from rosward.domain.unknown import Cause
from rosward.domain.values import FALSE, NONE, TRUE, UNBOUND, Class, Const, Ref, Value


@pytest.fixture
def machine() -> FakeMachine:
    return FakeMachine()


def dataclass(machine: FakeMachine, annotations: dict[str, str], *bases: Value, **given: Value) -> Class:
    noted = machine.new_dict({Const(k): Const(v) for k, v in annotations.items()})
    cls = machine.cls("Config", {"__annotations__": noted, **given}, *bases)
    decorated = machine.native("dataclasses.dataclass", cls)
    assert isinstance(decorated, Class)
    return decorated


def test_a_dataclass_has_an_init(machine: FakeMachine) -> None:
    cls = dataclass(machine, {"name": "str", "depth": "int"}, depth=Const(10))
    assert machine.plain(machine.call(cls, [Const("/scan")])) == {"name": "/scan", "depth": 10}
    assert machine.plain(machine.call(cls, [], {"depth": Const(1), "name": Const("x")})) == {"name": "x", "depth": 1}
    machine.call(cls, [])
    machine.call(cls, [], {"nme": Const("x")})
    assert [error for error, _ in machine.deaths] == ["TypeError", "TypeError"]


def test_factories_make_a_value_for_each_instance(machine: FakeMachine) -> None:
    machine.functions[Native("builtins.list")] = lambda: machine.new_list([])
    field = machine.native("dataclasses.field", default_factory=Native("builtins.list"))
    cls = dataclass(machine, {"topics": "list"}, topics=field)
    first, second = machine.call(cls, []), machine.call(cls, [])
    assert machine.load_attr(first, "topics") != machine.load_attr(second, "topics")


def test_fields_are_inherited_and_some_do_not_count(machine: FakeMachine) -> None:
    base = dataclass(machine, {"name": "str", "COUNT": "ClassVar[int]"})
    cls = dataclass(
        machine,
        {"_": "KW_ONLY", "depth": "int", "hidden": "int"},
        base,
        hidden=machine.native("dataclasses.field", init=FALSE, default=Const(7)),
    )
    made = machine.call(cls, [Const("/a")], {"depth": Const(2)})
    assert machine.plain(made) == {"name": "/a", "depth": 2, "hidden": 7}
    assert machine.plain(machine.native("dataclasses.asdict", made)) == {"name": "/a", "depth": 2, "hidden": 7}
    machine.call(cls, [Const("/a"), Const(2)])
    assert machine.deaths[-1][0] == "TypeError"


def test_post_init_gets_the_init_variables(machine: FakeMachine) -> None:
    seen: list[tuple[Value, ...]] = []

    def post(*args: Value) -> Value:
        seen.append(args)
        return NONE

    machine.functions[Native("demo.post")] = post
    cls = dataclass(machine, {"name": "str", "node": "InitVar[Node]"}, __post_init__=Native("demo.post"))
    made = machine.call(cls, [Const("a"), Const("the node")])
    assert seen == [(made, Const("the node"))]
    assert machine.plain(made) == {"name": "a"}


def test_decorator_with_arguments_equality_and_replace(machine: FakeMachine) -> None:
    decorator = machine.native("dataclasses.dataclass", frozen=TRUE)
    noted = machine.new_dict({Const("x"): Const("int")})
    cls = machine.call(decorator, [machine.cls("P", {"__annotations__": noted})])
    one, same, other = (machine.call(cls, [Const(v)]) for v in (1, 1, 2))
    assert machine.native("dataclasses.eq", one, same) == TRUE
    assert machine.native("dataclasses.eq", one, other) == FALSE
    assert machine.plain(machine.native("dataclasses.replace", one, x=Const(5))) == {"x": 5}
    assert machine.native("dataclasses.is_dataclass", one) == TRUE
    assert machine.native("dataclasses.is_dataclass", machine.allocate(Obj("instance", NONE))) == FALSE


def test_own_init_is_kept(machine: FakeMachine) -> None:
    cls = dataclass(machine, {"x": "int"}, __init__=Native("demo.init"))
    assert machine.heap[cls.address].attrs["__init__"] == Native("demo.init")


def test_named_tuple(machine: FakeMachine) -> None:
    base = machine.cls("_NamedTuple", {"__init__": Native("demo.init")}, stub=True)
    defaults = machine.new_list([Const(0)])
    cls = machine.native("collections._make_named_tuple", base, Const("Pose"), Const("x, y theta"), defaults)
    assert isinstance(cls, Class)
    assert cls.name == "Pose"
    made = machine.allocate(Obj("instance", cls))
    machine.native("collections._fill", made, Tuple((Const(1),)), machine.new_dict({Const("y"): Const(2)}))
    assert machine.native("collections._items", made) == Tuple((Const(1), Const(2), Const(0)))
    assert machine.native("collections._keys", made) == Tuple((Const("x"), Const("y"), Const("theta")))
    machine.native("collections._fill", machine.allocate(Obj("instance", cls)), Tuple(()), machine.new_dict({}))
    assert machine.deaths[0][0] == "TypeError"


def test_named_tuple_in_class_syntax(machine: FakeMachine) -> None:
    base = machine.cls("NamedTuple", {}, stub=True)
    noted = machine.new_dict({Const("name"): Const("str"), Const("depth"): Const("int")})
    cls = machine.cls("Topic", {"__annotations__": noted, "depth": Const(5)}, base)
    made = machine.allocate(Obj("instance", cls))
    machine.native("collections._fill", made, Tuple((Const("/a"),)), machine.new_dict({}))
    assert machine.native("collections._items", made) == Tuple((Const("/a"), Const(5)))


def enum(machine: FakeMachine, base_name: str = "Enum", *mixins: Value, **members: Value) -> Class:
    base = machine.cls(base_name, {}, stub=True)
    cls = machine.cls(
        "Side", {"__doc__": Const("x"), "_private_": Const(1), "f": Native("demo.f"), **members}, *mixins, base
    )
    machine.native("enum.make_members", cls)
    return cls


def test_members_have_name_and_value(machine: FakeMachine) -> None:
    cls = enum(machine, LEFT=Const("left"), RIGHT=Const("right"), ALSO_LEFT=Const("left"))
    attrs = machine.heap[cls.address].attrs
    assert machine.plain(attrs["LEFT"]) == {"name": "LEFT", "value": "left"}
    assert attrs["ALSO_LEFT"] == attrs["LEFT"]
    assert attrs["f"] == Native("demo.f")
    assert machine.iterate(machine.native("enum.iterate", cls)).known == (attrs["LEFT"], attrs["RIGHT"])
    assert machine.native("enum.lookup", cls, Const("right")) == attrs["RIGHT"]
    assert machine.native("enum.lookup", cls, attrs["RIGHT"]) == attrs["RIGHT"]
    assert machine.native("enum.item", cls, Const("RIGHT")) == attrs["RIGHT"]
    assert machine.native("enum.lookup", cls, Const("up")) is UNBOUND
    assert machine.deaths[-1][0] == "ValueError"
    either = machine.native("enum.lookup", cls, machine.unknown(Cause.PARAMETER, "side"))
    assert machine.native("enum.item", cls, machine.unknown(Cause.PARAMETER, "side")) == either


def test_functional_form(machine: FakeMachine) -> None:
    base = machine.cls("Enum", {}, stub=True)
    for names in (Const("LEFT, RIGHT"), machine.new_list([Const("LEFT"), Const("RIGHT")])):
        cls = machine.native("enum._make_class", base, Const("Side"), names, NONE, Const(1))
        assert isinstance(cls, Class)
        assert machine.plain(machine.heap[cls.address].attrs["RIGHT"]) == {"name": "RIGHT", "value": 2}


def test_auto(machine: FakeMachine) -> None:
    one, two, three = (External(f"enum.auto() {number}") for number in range(3))  # each call of auto() is another
    for base, given, expected in (
        ("Enum", 4, [1, 2, 4, 5]),
        ("Flag", 4, [1, 2, 4, 8]),
        ("StrEnum", "four", ["a", "b", "four", "d"]),
    ):
        cls = enum(machine, base, A=one, B=two, C=Const(given), D=three, E=one)
        members = machine.iterate(machine.native("enum.iterate", cls)).known
        assert [machine.plain(machine.load_attr(m, "value")) for m in members] == expected


def test_members_with_data_act_as_it(machine: FakeMachine) -> None:
    cls = enum(machine, "Enum", Native("builtins.str"), SCAN=Const("/scan"))
    attrs = machine.heap[cls.address].attrs
    scan = attrs["SCAN"]
    assert isinstance(scan, Ref)
    assert machine.heap[scan.address].payload == Const("/scan")
    assert machine.call(attrs["__add__"], [scan, Const("/raw")]) == Const("/scan/raw")
    assert machine.call(attrs["__radd__"], [scan, Const("/ns")]) == Const("/ns/scan")
    assert machine.call(attrs["__eq__"], [scan, Const("/scan")]) == TRUE


def test_own_init_of_members(machine: FakeMachine) -> None:
    seen: list[tuple[Value, ...]] = []

    def init(*args: Value) -> Value:
        seen.append(args)
        return NONE

    machine.functions[Native("demo.init")] = init
    cls = enum(machine, "Enum", PLANET=Tuple((Const(1), Const(2))), __init__=Native("demo.init"))
    assert seen == [(machine.heap[cls.address].attrs["PLANET"], Const(1), Const(2))]
