# SPDX-License-Identifier: Apache-2.0
"""Branches, loops, `try` and `with`: what decides that a block runs is part of whatever is written in it.

if msg.data > 3: self.on = True      the message decides: control
if msg.data: return                  it decides all that follows in the function
for p in msg.points: …               how many there are decides what the body does
try: x = int(text) except …          the handler runs because of what the body reads
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from rosward.flow import implicit
from rosward.flow.body import Attempt, Body, Point, joined
from rosward.flow.calls import run_callees, run_to_the_end
from rosward.flow.cpp import calls as cpp_calls
from rosward.flow.marks import HANDLED, NOTHING, Mark, demoted
from rosward.flow.reading import elements, narrowed, opaque, truth
from rosward.flow.stored.content import TooLongError
from rosward.ir import ops

if TYPE_CHECKING:
    from rosward.engine.running.seen import Seen
    from rosward.flow.stored.memory import Memory
    from rosward.flow.walker import Walker


def decides(walker: Walker, mark: Mark) -> int:
    """What the truth of a value decides."""
    return demoted(truth(walker, mark))


def _runs(block: ops.Block, body: Body) -> bool:
    """Whether a block ran; of an empty one nobody knows."""
    return not block or block[0].number in body.activation.seen


def _asked(walker: Walker, op: ops.If | ops.While, body: Body, seen: Seen) -> int:
    """What an object says of itself that is a condition (`__bool__`, `operator bool`)."""
    if seen.bound:
        given = cpp_calls.callees(walker, body, seen, body.registers[op.test])
    else:
        given = run_callees(walker, op, body, seen)
    return 0 if given is None else demoted(given.mask)


def branch(walker: Walker, op: ops.If, body: Body, seen: Seen) -> bool:
    """The ways that were followed, and joined behind."""
    then, other = _runs(op.then, body), _runs(op.orelse, body)
    if then != other:
        return walker.run(op.then if then else op.orelse, body)
    outside = body.pc
    inside = outside | decides(walker, body.registers[op.test]) | _asked(walker, op, body, seen)
    before = walker.point(body)
    name = body.tests.get(op.test, "")
    about = name in walker.shape.parameters
    if about:
        walker.narrowed.append(name)
    after, left, gone_on = _side(walker, op.then, body, narrowed(walker, inside))
    if about:
        walker.narrowed.pop()
    walker.go(body, before)
    otherwise, left_too, gone_on_too = _side(walker, op.orelse, body, inside)
    after = joined(after, otherwise)
    body.left |= left | left_too
    body.pc = outside | body.left | gone_on | gone_on_too
    if after is None:
        return False
    walker.go(body, after)
    return True


def _side(walker: Walker, block: ops.Block, body: Body, pc: int) -> tuple[Point | None, int, int]:
    """One side of a branch: its end, where control comes there; what decides all that follows, as the function, or the loop, was left in it."""
    leaves, turned = body.leaves, body.turned
    body.pc, body.turned = pc, 0
    end = walker.point(body) if walker.run(block, body) else None
    gone_on, body.turned = body.turned, turned | body.turned
    return end, pc if body.leaves != leaves else 0, gone_on


def leave(walker: Walker, op: ops.Return, body: Body, _seen: Seen) -> bool:
    """Return."""
    body.leaves += 1
    body.result = body.result.joined(body.registers[op.src].under(body.pc))
    body.leave(walker.memory)
    return False


def break_(walker: Walker, _op: ops.Break, body: Body, _seen: Seen) -> bool:
    """Leave the loop."""
    body.turned |= body.pc
    body.broken = joined(body.broken, walker.point(body))
    return False


def continue_(walker: Walker, _op: ops.Continue, body: Body, _seen: Seen) -> bool:
    """Go on with the next turn."""
    body.turned |= body.pc
    body.continued = joined(body.continued, walker.point(body))
    return False


def raise_(walker: Walker, op: ops.Raise, body: Body, seen: Seen) -> bool:
    """Leave for the innermost `try`, where there is one around."""
    if op.src != ops.NO_REGISTER:
        _raises(walker, body.registers[op.src].under(body.pc))
    if walker.attempts:
        body.leaves += 1
        walker.attempts[-1].mask |= body.pc
    run_callees(walker, op, body, seen)
    return False


def _raises(walker: Walker, raised: Mark) -> None:
    """An exception comes to the innermost `try`; where there is none, to who asks what nobody caught."""
    if walker.attempts:
        walker.attempts[-1].raises(raised, walker.memory.deep(raised))
    else:
        walker.memory.write_any((HANDLED,), raised)


_MOST_TURNS: Final = 60


def _interleave(walker: Walker) -> None:
    """Another thread may have run before a turn: what callbacks write may stand here."""
    if walker.threaded:
        walker.join_beside()


def loop(walker: Walker, op: ops.While, body: Body, seen: Seen) -> bool:
    """Turns until nothing changes."""

    def begin() -> bool:
        _interleave(walker)
        return walker.run(op.condition, body)

    def test() -> int:
        return decides(walker, body.registers[op.test]) | _asked(walker, op, body, seen)

    return _turns(walker, op, body, begin, test)


def for_each(walker: Walker, op: ops.ForEach, body: Body, seen: Seen) -> bool:
    """The same over elements."""
    iterable = body.registers[op.iterable]
    said = 0  # by methods of the program, of how many elements there are

    def begin() -> bool:
        nonlocal said
        _interleave(walker)
        item = elements(walker, iterable)
        given, said = run_to_the_end(walker, op, body, seen)
        item = item if given is None else item.joined(implicit.gone_through(walker, given))
        if seen.refs:  # C++: the interpretation has seen which
            item = Mark(item.mask, frozenset(seen.refs) | opaque(item))
        if given is not None:
            said |= walker.memory.size(given.roots)  # once a generator among them has run
        body.registers[op.item] = item.under(body.pc)
        walker.wrote(body, (op.item,))
        return True

    def test() -> int:
        return demoted(iterable.mask | walker.memory.size(iterable.roots) | said)

    return _turns(walker, op, body, begin, test, op.item)


def _turns(walker: Walker, op: Any, body: Body, begin: Any, test: Any, item: int = ops.NO_REGISTER) -> bool:
    """`item`: the register that keeps what it held where there is no further element."""
    outer = body.broken, body.continued, body.turned
    body.enter_loop()
    outside = body.pc
    ended: Point | None = None
    head = walker.point(body)
    way = walker.way(op)
    before_it = walker.heads.get(way)
    if before_it is not None:  # whoever comes here again finds at least what was found then
        head.join(before_it)
    for _ in range(_MOST_TURNS):
        walker.go(body, head.copy())
        before = body.pc
        kept = body.registers[item]
        if not begin():
            break
        decided = test()
        ended = walker.point(body)
        if item != ops.NO_REGISTER:
            ended.registers[item] = kept.under(decided)
        if not _runs(op.body, body):
            break
        body.pc |= decided
        ran = walker.run(op.body, body)
        after = joined(body.continued, walker.point(body) if ran else None)
        body.continued = None
        if after is None or (not head.join(after) and before == body.pc):
            break
    else:
        raise TooLongError
    walker.heads[way] = head
    broken = body.broken
    if broken is None:
        body.pc = outside | body.left
    body.broken, body.continued, body.turned = outer
    alive = False
    if ended is not None:
        walker.go(body, ended)
        alive = not _is_forever(op) and walker.run(op.orelse, body)  # where there is a `break`, it decides
    body.pc = outside | body.left
    if broken is not None:
        if alive:
            broken.join(walker.point(body))
        walker.go(body, broken)
        return True
    return alive


def _is_forever(op: ops.While | ops.ForEach) -> bool:
    return isinstance(op, ops.While) and len(op.condition) == 1 and op.condition[0].__class__ is ops.Const


def _try(walker: Walker, block: ops.Block, body: Body, *, handles: bool = False) -> tuple[bool, Attempt]:
    """A block that may be left anywhere: whether its end is reached, and all states in which it may have been left."""
    tried = Attempt(body, Point(body.registers, walker.memory), handles=handles)
    walker.attempts.append(tried)
    try:
        alive = walker.run(block, body)
    finally:
        walker.attempts.pop()
        tried.end(walker.memory)
    # Nobody knows whether what left it is caught.
    if walker.attempts:
        walker.attempts[-1].contains(tried)
    if tried.raised is not NOTHING:
        _raises(walker, tried.raised)
    return alive, tried


def attempt(walker: Walker, op: ops.Try, body: Body, _seen: Seen) -> bool:
    """The body; each handler from every state in which the body may be left; what is in `finally` on each way."""
    outside = body.pc
    alive, tried = _try(walker, op.body, body, handles=bool(op.handlers))
    if op.handlers:
        body.pc |= demoted(tried.mask)
    alive = alive and walker.run(op.orelse, body)
    after = walker.point(body) if alive else None
    inside = outside | demoted(tried.mask)
    leaves = body.leaves
    for handler in op.handlers:
        if not (_runs(handler.match, body) and _runs(handler.body, body)):
            continue
        walker.go(body, tried.point.copy())
        body.pc = inside
        raised = tried.raised.under(tried.mask | inside)
        walker.memory.write_any((HANDLED,), raised)
        if handler.bind != ops.NO_REGISTER:
            body.registers[handler.bind] = raised
        if walker.run(handler.match, body) and walker.run(handler.body, body):
            after = joined(after, walker.point(body))
    body.pc = outside | body.left | body.turned
    if body.leaves != leaves:
        body.left |= inside
        body.pc |= inside
    if op.final:
        return _finally(walker, op.final, body, after, tried)
    if after is None:
        return False
    walker.go(body, after)
    return True


def _finally(walker: Walker, block: ops.Block, body: Body, after: Point | None, tried: Attempt) -> bool:
    """`finally` runs on every way out: what it writes is seen behind each of them."""
    every = tried.point.copy()
    if after is not None:
        every.join(after)
    for memory in _leaving(body):
        every.memory.join(memory)
    walker.go(body, every)
    if walker.run(block, body):
        for memory in _leaving(body):
            memory.join(walker.memory)
    if after is None:
        return False
    walker.go(body, after)
    return walker.run(block, body)


def _leaving(body: Body) -> list[Memory]:
    """What is known where control has left the function or the loop."""
    points = [p.memory for p in (body.broken, body.continued) if p is not None]
    return points if body.returned is None else [body.returned, *points]


def with_context(walker: Walker, op: ops.With, body: Body, seen: Seen) -> bool:
    """What `__enter__` gives, the body, `__exit__`."""
    context = body.registers[op.context]
    waits = any(a.code.name in _WAITING for a in seen.callees)
    entered = run_callees(walker, op, body, seen, ("__enter__", "__aenter__"))
    if waits:
        walker.wait()
    if op.bind != ops.NO_REGISTER:
        given = context if entered is None else entered
        body.registers[op.bind] = Mark(given.mask | body.pc, given.roots | frozenset(seen.refs))
        walker.wrote(body, (op.bind,))
    outside = body.pc
    alive, tried = _try(walker, op.body, body, handles=seen.swallows)
    if seen.swallows:
        body.pc = outside | body.left | body.turned
        after = joined(tried.point, walker.point(body) if alive else None)
        assert after is not None
        walker.go(body, after)
    elif not alive:
        if not seen.alive:
            return False
        walker.go(body, tried.point)
    raised = tried.raised.under(demoted(tried.mask))
    run_callees(walker, op, body, seen, ("__exit__", "__aexit__"), told=raised)
    if waits:
        walker.wait()
    return seen.alive


_WAITING: Final = frozenset(("__aenter__", "__aexit__"))
"""Methods that let others run meanwhile."""
TABLE: Final[dict[type[ops.Op], Any]] = {
    ops.If: branch,
    ops.While: loop,
    ops.ForEach: for_each,
    ops.Try: attempt,
    ops.With: with_context,
    ops.Return: leave,
    ops.Break: break_,
    ops.Continue: continue_,
    ops.Raise: raise_,
}
