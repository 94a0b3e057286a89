# SPDX-License-Identifier: Apache-2.0
"""C++: models in code, and code that nobody knows.

values.push_back(x);         the vector that the interpretation saw written holds x among others
vendor::fill(frame, data);   nobody knows: what is passed may hold any of the arguments afterwards
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, TypeGuard

from rosward.domain.choice import options
from rosward.domain.values import Ref
from rosward.effects.flows import Source
from rosward.engine.running.seen import Seen, refs_of
from rosward.flow import library
from rosward.flow.body import Body
from rosward.flow.cpp.values import (
    keys,
    nameless,
    objects,
    slots,
    under_choice,
    value,
)
from rosward.flow.marked_cpp import COPIES, COUNTS, FILLS, LOGS, MOVES, READS, SIZES, SORTS, STORES, STREAMS, is_setter
from rosward.flow.marks import HANDLED, NOTHING, Mark, Root, demoted, is_slot, slot_of
from rosward.flow.native import parameters
from rosward.flow.outside import cleaned, comes_in, out
from rosward.flow.reading import arising
from rosward.flow.stored.content import Content

if TYPE_CHECKING:
    from rosward.flow.walker import Walker


def natives(
    walker: Walker,
    body: Body,
    seen: Seen,
    marks: list[Mark],
    constants: tuple[object, ...] = (),
    *,
    done: frozenset[Root] = frozenset(),
) -> Mark | None:
    """What models in code give, and what they write; None where none runs.

    `done`: into these objects was written what they are given, but for what comes from outside.
    """
    wrote = {a for a in seen.wrote if a not in seen.made and a not in done}
    if not (seen.natives or wrote):
        return None
    near, passed = Mark(body.pc), frozenset[Root]()
    for mark in marks:
        near = near.joined(value(walker, mark))
        passed |= slots(mark)
    names = [n for n in seen.natives if n not in _QUIET]
    if passed and not all(n.endswith(".erase") for n in names):  # iterators into maps lead to keys, too
        near = near.under(keys(walker, passed))
    whole = near
    last = [n.rpartition(".")[2] for n in names]
    own = bool(names) and all(
        n.startswith("rosward.") for n in names
    )  # a node is given for what it is, not for what is in it
    simple = bool(seen.refs) and not seen.reasons
    is_size = bool(names) and all(n in SIZES for n in last)
    if is_size:
        near = whole = near.under(walker.memory.size(near.roots))
    elif last == ["is_open"]:  # what was written there does not matter
        near = whole = near.under(_opened(walker, near))
    elif not own and not (names and all(n in STORES or (simple and n in READS) for n in last)):
        whole = Mark(walker.memory.deep(near), near.roots | passed)
    brought = _brought(walker, body, seen, names, marks, constants, near, whole)
    content = near if names and all(n in STORES for n in last) else whole
    if last == ["reset"]:  # what it held until then is not in it any more
        content = whole = _all(walker, marks[1:]).under(under_choice(body, marks[0]))
    written = Mark(content.mask | brought, frozenset(r for r in whole.roots if not is_slot(r)))
    if not any(n in _ARRIVING or n in _REGISTERING for n in names):
        _made(walker, seen, written, body.pc | near.mask, done, brought)
    _written(walker, marks, seen, wrote, written, body)
    for names_of, some in ((FILLS, marks[:1]), (COPIES, marks[1:])):
        if not names_of.isdisjoint(last):  # a part of something that is not known (`strncpy(request.ifr_name, …)`)
            walker.memory.write_any(nameless(_all(walker, some)), Mark(written.mask), written.mask)
    if not MOVES.isdisjoint(last):
        _moved(walker, wrote, near if seen.bound or SORTS.isdisjoint(last) else written)
    if own:
        passed_on = Mark(whole.mask, nameless(whole)) if not _PASSING.isdisjoint(names) else NOTHING
        return passed_on.under(body.pc | brought | arising(walker, seen))
    if seen.bound and not names:  # what bodies give says it
        return None
    mask = whole.mask | brought | arising(walker, seen)
    return Mark(mask, nameless(whole))


def _brought(
    walker: Walker,
    body: Body,
    seen: Seen,
    names: list[str],
    marks: list[Mark],
    constants: tuple[object, ...],
    near: Mark,
    whole: Mark,
) -> int:
    """What models in code bring in from outside; what they send out is sent."""
    brought = 0
    for name in names:
        if name.startswith(LOGS):
            _log(walker, body, marks if name.startswith("RCUTILS_") else marks[1:])  # others get a logger first
        brought |= library.perform(walker, name, whole.mask, body.pc)
        kind = stream(walker, near) if name in _WRITES else ""
        kind = STREAMS.get(name.rpartition(".")[0], kind)
        if kind not in ("", "text"):
            out(walker, kind, whole.mask)
        if name == "std.getline" and (comes := stream(walker, near) or "stdin") != "text":
            brought |= comes_in(walker, comes)
        if name.endswith(".reset"):  # what nobody holds any more runs no more
            for root in near.roots:
                library.stop(walker, root, body.pc | demoted(near.mask))
        brought |= _of_library(walker) if name == "rosward.unknown" else 0
        if name in _ARRIVING or (name == "rosward.unknown" and constants[:1] == ("message",)):
            brought |= _arrives(walker, body, seen, name)
        if name.startswith("rosward."):
            brought |= _parameter(walker, body, seen, name, marks, constants)
    return brought


def _made(walker: Walker, seen: Seen, written: Mark, size: int, done: frozenset[Root], brought: int) -> None:
    """What is made holds what it is made of."""
    begun = {a for b in seen.bound.values() for g in b.given[:1] for a in g.places}
    for address, site in seen.made.items():
        if (_is_copy(site) and site[1] not in seen.made) or address in begun:
            continue
        if address in done and not _wraps(site):
            walker.memory.write_any([address], Mark(brought))
        else:
            walker.memory.write_any([address], written, size)


def _wraps(site: object) -> bool:
    """Whether what is made of a value holds another object: a `std::optional`, or a variant."""
    return isinstance(site, tuple) and getattr(site[0], "name", "") in ("std.optional", "std.variant", "std.any")


def _all(walker: Walker, marks: list[Mark]) -> Mark:
    """The values of several registers, with all that they lead to."""
    found = NOTHING
    for mark in marks:
        found = found.joined(value(walker, mark))
    return Mark(walker.memory.deep(found), found.roots)


def _parameter(
    walker: Walker, body: Body, seen: Seen, name: str, marks: list[Mark], constants: tuple[object, ...]
) -> int:
    """The parameter that a native of the models gives, or writes to a variable: of one that is not known, any."""
    known = constants[1] if len(constants) > 1 else None
    nodes = value(walker, marks[0]).roots if marks else frozenset()
    if name in _PARAMETERS_SET:
        given = value(walker, marks[2]) if len(marks) > 2 else NOTHING
        parameters.keep(walker, nodes, known, given.under(value(walker, marks[1]).mask), body.pc)
    if name in _PARAMETERS_ASKED:
        return parameters.declared(walker, nodes)
    if name not in _PARAMETERS_READ:
        return 0
    found = parameters.kept(walker, nodes, known)
    if not isinstance(known, str) and arising(walker, seen):
        return found
    return found | walker.sources.data(Source("parameter", known if isinstance(known, str) else "*"))


_PARAMETERS_SET: Final = frozenset(
    f"rosward.{name}" for name in ("declare_parameter", "set_parameter", "undeclare_parameter")
)
_PARAMETERS_READ: Final = frozenset(
    f"rosward.{name}"
    for name in ("declare_parameter", "parameter", "get_parameter", "get_parameters", "given_parameters")
)
_PARAMETERS_ASKED: Final = frozenset(f"rosward.{name}" for name in ("has_parameter", "is_given"))


def _of_library(walker: Walker) -> int:
    """`rosward::unknown(…)`: what a library makes of all that it was given."""
    mask, nodes = 0, walker.shape.nodes
    for body in reversed(walker.bodies):
        if not body.activation.code.file.startswith("models:"):
            break
        for mark in body.arguments:
            held = value(walker, mark)
            mask |= walker.memory.deep(Mark(held.mask, held.roots - nodes))
    return mask


def _is_copy(site: object) -> TypeGuard[tuple[str, int]]:
    return isinstance(site, tuple) and site[:1] == ("copy",)


def _written(walker: Walker, marks: list[Mark], seen: Seen, wrote: set[int], written: Mark, body: Body) -> None:
    """What the interpretation saw written holds more now: the variables that were passed, else any part of the object.

    What is passed of a container is an iterator: what is inserted there, or written from there on, may be any element.
    """
    own = bool(seen.natives) and all(n.startswith("rosward.") for n in seen.natives)
    counts = bool(seen.natives) and all(n.rpartition(".")[2] in COUNTS for n in seen.natives)
    for address in wrote:
        passed = {r for mark in marks for r in mark.roots if is_slot(r) and slot_of(r)[0] == address}
        if own and not passed:  # what the models note in their own objects is no content
            continue
        record = walker.shape.record(address)
        variable = record is None or record.kind not in _CONTAINERS
        walker.memory.write_any(
            passed if passed and variable else [address],
            Mark(written.mask, written.roots - {address}),
            under_choice(body, marks[0]) if counts and not variable else body.pc | written.mask,
        )


def _moved(walker: Walker, wrote: set[int], by: Mark) -> None:
    """Objects that stand in a container change their places in it: which one is where, is decided by what they were compared by."""
    for address in wrote:
        record = walker.shape.record(address)
        if record is not None and record.kind == "list":
            values = [o for v in (*(record.items or ()), record.rest) if v is not None for o in options(v)]
            parts = [part for v in values if v.__class__ is Ref for part in refs_of(v)]
            walker.memory.write_any(parts, Mark(demoted(by.mask)))


_CONTAINERS: Final = frozenset({"list", "set", "dict"})
_PASSING: Final = frozenset(
    f"rosward.{name}" for name in ("either", "parameter_value", "parameter_as", "parameter_text")
)
"""What the models make of what they are given."""
_QUIET: Final = frozenset({"rosward.nothing", "rosward.type"})


_REGISTERING: Final = frozenset({"rosward.deliver", "rosward.serve"})
"""They make what will arrive at a callback, which holds nothing of that."""
_ARRIVING: Final = frozenset({"rosward.arrived", "rosward.message", "rosward.fill"})


def _arrives(walker: Walker, body: Body, seen: Seen, name: str) -> int:
    """Something that somebody sent arrives here."""
    mask = body.pc
    for inner in reversed(walker.bodies):
        code = inner.activation.code
        if not code.file.startswith("models:"):
            break
        kind = _kind(inner)
        if kind:
            mask |= walker.arrives_here(kind)
            break
    for address in (*seen.refs, *seen.made, *(seen.wrote if name == "rosward.fill" else ())):
        if isinstance(address, int):
            walker.memory.place_again(address, Content(base=mask))
    return mask


_KINDS: Final = {
    "ServerGoalHandle": "goal",
    "WrappedResult": "result",
    "rclcpp_action::Client": "feedback",
    "rclcpp::Client": "response",
    "GenericClient": "response",
    "AskedService": "response",
    "Subscription": "topic",
    "ParameterEventHandler": "topic",
    "OdomSmoother": "topic",
    "InteractiveMarkerServer": "topic",
    "CameraSubscriber": "topic",
}


def _kind(body: Body) -> str:
    """What arrives at an object of the client library, by the function of it that says so."""
    name = body.activation.code.qualname
    return next((kind for part, kind in _KINDS.items() if part in name), "")


def _log(walker: Walker, body: Body, marks: list[Mark]) -> None:
    """A line of a log, of all that it is given."""
    mask = body.pc
    for mark in marks:
        mask |= walker.memory.deep(value(walker, mark))
    out(walker, "log", mask)


_FEW: Final = 12
"""Of more objects, those that code nobody knows gets hold of are one, if libraries made them."""
_OPENED, _WRITTEN = "opened", "written"
"""Under the one key stands what was written to the file of a stream; nothing is written under the other: it reads what the stream holds besides."""
_WRITES: Final = frozenset(f"std.stringstream.{name}" for name in ("write", "put"))
"""How streams are written to but by `<<`."""


def written_to(walker: Walker, kind: str, place: Mark, mask: int) -> None:
    """What a stream is given stays in it; of one that leads to a file, it is told apart from what says which file that is."""
    if kind == "file" and not any(map(is_slot, place.roots)):
        walker.memory.write(place.roots, _WRITTEN, walker.memory.read(place.roots, _WRITTEN).under(mask))
    elif kind != "stdout":
        walker.memory.write_any(place.roots, Mark(mask), mask)


def _opened(walker: Walker, mark: Mark) -> int:
    """Which file streams lead to."""
    return comes_in(walker, "file") | walker.memory.read(mark.roots, _OPENED).mask


def stream(walker: Walker, mark: Mark) -> str:
    """What kind of stream a value is; '' where it is none."""
    for root in mark.roots:
        if not isinstance(root, int):
            if root[0] == "external" and root[1] in STREAMS:
                return STREAMS[str(root[1])]
            continue
        record = walker.shape.record(root)
        name = str(getattr(getattr(record, "cls", None), "name", ""))
        if name.endswith("stream"):
            return "file" if "fstream" in name else "text"
    return ""


def strange(
    walker: Walker, op_number: int, body: Body, seen: Seen, marks: list[Mark], called: tuple[str, ...] = ()
) -> Mark | None:
    """Code that nobody knows: it may write to all that it is passed, and give any of it. None where none runs."""
    names: list[str] = []
    for name in seen.strange:
        names += called if called and name.startswith("something unknown") else (name.replace("::", "."),)
    if not names:
        return None
    memory = walker.memory
    mask = body.pc
    behind: frozenset[Root] = frozenset()
    reached: set[Root] = set()
    for mark in marks:
        held = value(walker, mark)
        mask |= memory.deep(held)
        behind |= nameless(held) | objects(held)
        if mark is marks[0] or mark is marks[-1]:  # what it is called on
            behind |= slots(mark)
        reached |= slots(mark)
        reached.update(memory.reached(held))
    given = 0
    for name in names:
        given |= library.perform(walker, name, mask, body.pc)
    if "std.current_exception" in names:
        handled = memory.of(HANDLED).whole
        mask, behind = mask | memory.deep(handled), behind | handled.roots
    if "std.rethrow_exception" in names and walker.attempts:
        walker.attempts[-1].raises(Mark(mask, behind), mask)
    root = walker.shape.made(body.activation, op_number, names[0])
    memory.renew(root)
    known = [walker.shape.said(n) for n in names]
    if all(said.releases for said in known):
        cleaned(walker, names[0], mask)
        return Mark(body.pc | given, frozenset((root,)))
    if not all(said.is_known and not said.changes for said in known) or any(map(is_setter, names)):
        memory.write_any(reached, Mark(mask | given, behind), mask | given)
        if len(reached) > _FEW:  # it may have written each into each
            memory.merge(reached)
            behind = walker.shape.numbers.canonical(behind)
    return Mark(mask | given, behind | {root})
