# SPDX-License-Identifier: Apache-2.0
"""The operations that C++ alone has: names looked up in scopes, slots, copies, construction, calls by reference.

A register holds a value, or a *slot*: where a value stands (`domain.slots.Slot`), or the object itself (a `Ref`), for an object is
its own slot. Where the fields below say "slot", either may be there; `Read` gives the value.

    x_ = y            Name r1 'x_' slot; Name r2 'y'; Assign r1 '=' r2
    get("n", x_)      Name r1 'get'; Const r2 "n"; Name r3 'x_' slot; Invoke r0 r1 (value r2, slot r3)
    p->go()           Name r1 'p'; Deref r2 r1 slot; InvokeMember r0 r2 'go' ()

Types are values: a template parameter is a variable that holds one.
"""

from __future__ import annotations

from rosward.ir.cpp_calls import Argued, Default, Elements, Invoke, InvokeMember, Kind, MakeLambda, Placed, Spread
from rosward.ir.cpp_names import (
    AddressOf,
    CellSlot,
    Declared,
    Deref,
    Item,
    LocalSymbol,
    MakeType,
    Member,
    Name,
    Part,
    Read,
    TypeOfValue,
    UnknownValue,
)
from rosward.ir.cpp_values import (
    Assign,
    Braces,
    Construct,
    Convert,
    Copy,
    Destructure,
    EndScope,
    Form,
    Initialise,
    MemberInit,
    Narrow,
    StaticLocal,
    Step,
)

__all__ = [
    "AddressOf",
    "Argued",
    "Assign",
    "Braces",
    "CellSlot",
    "Construct",
    "Convert",
    "Copy",
    "Declared",
    "Default",
    "Deref",
    "Destructure",
    "Elements",
    "EndScope",
    "Form",
    "Initialise",
    "Invoke",
    "InvokeMember",
    "Item",
    "Kind",
    "LocalSymbol",
    "MakeLambda",
    "MakeType",
    "Member",
    "MemberInit",
    "Name",
    "Narrow",
    "Part",
    "Placed",
    "Read",
    "Spread",
    "StaticLocal",
    "Step",
    "TypeOfValue",
    "UnknownValue",
]
