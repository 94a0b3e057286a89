# SPDX-License-Identifier: Apache-2.0
"""One run of a program under the real rclpy, with its real nodes: everything happens in a fixed order, and what it sends is noted.

    Run("relay.py", code, Contents({}, {})).go()    -> {("topic:/out", 0): [("0 topic:/in", "std_msgs.msg.Float64(data=1.0)")]}

`spin` is a schedule: in each round each subscription gets a message, each service a request, each timer runs, requests are answered, each
parameter is set. Nothing goes over the middleware.
"""

from __future__ import annotations

import contextlib
import gc
import inspect
from collections.abc import Callable, Iterator
from functools import partial
from types import CodeType, SimpleNamespace
from typing import Any, Final, final

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.client import Client
from rclpy.executors import Executor
from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.publisher import Publisher
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.task import Future

from .flow_contents import Contents
from .flow_outside import IdleError, line_of, surrounded

ROUNDS: Final = 4
_OKS: Final = 3
"""So many turns a loop over `rclpy.ok()` takes in each round."""
_OWN: Final = ("use_sim_time", "start_type_description_service")
_ENDPOINTS: Final = ("Node", "Publisher", "Subscription", "Service", "Client", "ActionServer", "ActionClient")

Sent = dict[tuple[str, int], list[tuple[str, str]]]
"""By sink and line (0 for those that have a name): when something was sent, and what."""


@final
class Run:
    """What one run does. `absent`: the input that never arrives; `backward`: the order of callbacks in each round is the other one."""

    def __init__(
        self, file: str, code: CodeType, contents: Contents, *, absent: str = "", backward: bool = False
    ) -> None:
        self.file, self.code, self.contents, self.absent, self.backward = file, code, contents, absent, backward
        self.output: Sent = {}
        self.inputs: set[str] = set()
        self.parameters: dict[str, Any] = {}  # by name, what each is declared with
        self.errors: list[str] = []
        self.nodes: list[Any] = []
        self.overrides: dict[str, Any] = {}
        self.made: dict[Any, int] = {}
        self._when = "main"
        self._round = 0
        self._oks = _OKS * ROUNDS
        self._threads: list[Callable[[], object]] = []
        self._pending: list[tuple[str, Any, Callable[[Any], object]]] = []  # requests that wait for an answer
        self._waiting: list[tuple[Any, Callable[[Any], object]]] = []  # coroutines

    def go(self) -> Sent:
        """Run it to its end."""
        _Stage.run = self
        names = {"__name__": "__main__", "__file__": self.file, "__builtins__": surrounded(self)}
        try:
            exec(self.code, names)
        except (Exception, IdleError, SystemExit) as error:
            self._failed(error)
        finally:
            for coroutine, _ in self._waiting:
                coroutine.close()
            for node in self.nodes:
                for timer in list(node.timers):
                    timer.destroy()
            for kept in (self.nodes, self._threads, self._pending, self._waiting):
                kept.clear()
        return self.output

    # What the program meets

    def sent(self, sink: str, what: object, *, by_line: bool = False) -> None:
        """Something leaves."""
        line = line_of(self.file) if by_line else 0
        self.output.setdefault((sink, line), []).append((self._when, repr(what)))

    def comes(self, source: str, like: Any) -> Any:
        """Something comes from outside."""
        self.inputs.add(source)
        return self.contents.like(source, self._when, like)

    def thread(self, target: Callable[[], object]) -> None:
        """A thread starts."""
        self._threads.append(target)

    def ask(self, source: str, make: Callable[[], Any]) -> Future[Any]:
        """Something is asked that will be answered."""
        future: Future[Any] = _Promise()
        self._pending.append((source, make, future.set_result))
        return future

    def tell(self, source: str, make: Callable[[], Any], callback: Callable[[Any], object]) -> None:
        """Something will be told by the other side."""
        self._pending.append((source, make, callback))

    def arriving(self, source: str, kind: type) -> Any:
        """A message, request or answer."""
        self.inputs.add(source)
        return self.contents.filled(source, self._round, kind)

    def goes_on(self) -> bool:
        """Whether a loop over `rclpy.ok()` takes another turn."""
        self._oks -= 1
        return self._oks >= 0 and self._round < ROUNDS

    # What happens

    def happen(self) -> None:
        """All rounds."""
        while self._round < ROUNDS:
            self.turn()

    def turn(self) -> None:
        """One round."""
        events = [e for node in self.nodes for e in self._events(node)]
        for source, what in reversed(events) if self.backward else events:
            self._event(source, what)
        for number in range(len(self._threads)):
            self._event(f"thread {number}", partial(self._advance_thread, number))
        self.answer()
        for node in self.nodes:
            for name in sorted(set(node._parameters) - set(_OWN)):
                self._set(node, name)
        self._round += 1

    def answer(self) -> None:
        """Everything that was asked is answered."""
        for _ in range(3):
            pending, self._pending = self._pending, []
            for source, make, give in pending:
                self._event(source, partial(_hand_over, make, give))

    def _event(self, source: str, what: Callable[[], object]) -> None:
        if source == self.absent:
            return
        before, self._when = self._when, f"{self._round} {source}"
        self._oks = _OKS
        self.call(what)
        for coroutine, give in list(self._waiting):
            self._waiting.remove((coroutine, give))
            self._advance(coroutine, give)
        self._when = before

    def call(self, function: Callable[..., object], *arguments: object, give: Callable[[Any], object] = bool) -> None:
        """Call something of the program; `give` gets the result."""
        try:
            result = function(*arguments)
        except (Exception, SystemExit) as error:
            self._failed(error)
            return
        if inspect.iscoroutine(result):
            self._advance(result, give)
        else:
            give(result)

    def _advance(self, coroutine: Any, give: Callable[[Any], object]) -> None:
        try:
            coroutine.send(None)
        except StopIteration as end:
            give(end.value)
        except Exception as error:
            self._failed(error)
        else:
            self._waiting.append((coroutine, give))

    def _failed(self, error: BaseException) -> None:
        self.errors.append(f"{self._when}: {type(error).__name__}: {error}")

    def _advance_thread(self, number: int) -> None:
        """What waits for something goes on in the next round."""
        target = self._threads[number]
        with contextlib.suppress(IdleError):
            target()
            if self._oks >= 0:
                self._threads[number] = lambda: None

    def _set(self, node: Any, name: str) -> None:
        source = f"parameter:{name}"
        value = node._parameters[name].value
        if value is not None:
            self.inputs.add(source)
            new = Parameter(name, value=self.contents.like(source, self._round, value))
            self._event(source, lambda: node.set_parameters([new]))

    def _events(self, node: Any) -> Iterator[tuple[str, Callable[[], object]]]:
        for subscription in [s for s in node.subscriptions if not _of_library(s.callback)]:
            source = f"topic:{subscription.topic_name}"
            yield source, partial(self._receive, node, subscription, source)
        for service in list(node.services):
            if not _of_library(service.callback):
                yield f"service:{service.service_name}", partial(self._serve, service)
        for timer in list(node.timers):
            yield "timer", partial(self._tick, timer)
        for server in [w for w in node.waitables if isinstance(w, ActionServer)]:
            yield f"goal:{server.flow_name}", partial(self._serve_goal, server)

    def _tick(self, timer: Any) -> None:
        if not timer.is_canceled():
            self.call(timer.callback)

    def _receive(self, node: Any, subscription: Any, source: str) -> None:
        if subscription in list(node.subscriptions):
            self.call(subscription.callback, self.arriving(source, subscription.msg_type))

    def _serve(self, service: Any) -> None:
        name = service.service_name
        request = self.arriving(f"service:{name}", service.srv_type.Request)
        self.call(
            service.callback, request, service.srv_type.Response(), give=lambda r: self.sent(f"response:{name}", r)
        )

    def _serve_goal(self, server: Any) -> None:
        name = server.flow_name
        goal = self.arriving(f"goal:{name}", server._action_type.Goal)
        handle = SimpleNamespace(
            request=goal,
            is_cancel_requested=False,
            is_active=True,
            publish_feedback=lambda f: self.sent(f"feedback:{name}", f),
            succeed=lambda *_: None,
            abort=lambda *_: None,
            canceled=lambda *_: None,
            execute=lambda *_: None,
        )
        self.call(server._execute_callback, handle, give=lambda r: self.sent(f"result:{name}", r))


def _hand_over(make: Callable[[], Any], give: Callable[[Any], object]) -> None:
    give(make())


def _of_library(callback: object) -> bool:
    return str(getattr(callback, "__module__", "")).startswith("rclpy.")


class _Promise(Future):  # type: ignore[type-arg,misc,unused-ignore]  # Any, where rclpy is not installed
    """A future whose callbacks are callbacks of the program."""

    _callbacks: list[Any]

    def _schedule_or_invoke_done_callbacks(self) -> None:
        callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            _Stage.run.call(callback, self)

    def add_done_callback(self, callback: Any) -> None:
        """Call it, now or then."""
        if self.done():
            _Stage.run.call(callback, self)
        else:
            self._callbacks.append(callback)


class _Stage:
    """The run that is on."""

    run: Run
    kept: Final[dict[Any, Any]] = {}


def install() -> None:
    """From now on what the classes of rclpy do reaches the run that is on."""
    start = Node.__init__

    def begin(node: Any, *arguments: Any, **options: Any) -> None:
        run = _Stage.run
        given = [Parameter(n, value=v) for n, v in {**run.overrides, "start_type_description_service": False}.items()]
        quiet = {"enable_rosout": False, "start_parameter_services": False}
        start(node, *arguments, **{**options, **quiet, "parameter_overrides": given})
        run.nodes.append(node)

    declare = Node.declare_parameter

    def declared(node: Any, name: str, value: Any = None, *arguments: Any, **options: Any) -> Any:
        _Stage.run.parameters.setdefault(name, value)
        return declare(node, name, value, *arguments, **options)

    Node.__init__, Node.declare_parameter = begin, declared
    rclpy.init()
    rclpy.init = rclpy.shutdown = rclpy.try_shutdown = lambda *_, **__: None
    rclpy.ok = rclpy.utilities.ok = lambda **_: _Stage.run.goes_on()
    rclpy.spin = Executor.spin = lambda *_, **__: _Stage.run.happen()
    rclpy.spin_once = Executor.spin_once = lambda *_, **__: _Stage.run.turn()
    rclpy.spin_until_future_complete = Executor.spin_until_future_complete = lambda *_, **__: _Stage.run.answer()
    Executor.add_node = lambda *_: True
    Publisher.publish = _publish
    RcutilsLogger.log = lambda _, text, *__, **___: _Stage.run.sent("log", text, by_line=True)
    _install_clients()
    for name in _ENDPOINTS:
        setattr(_rclpy, name, _kept(getattr(_rclpy, name)))
    for cls in (Publisher, Subscription, Service, Client):
        cls.destroy = lambda _: None
    for action in (ActionServer, ActionClient):
        action.destroy = lambda _: None
        action.__init__ = _named(action.__init__)


def _kept(make: Callable[..., Any]) -> Callable[..., Any]:
    """What stands in the middleware is made once for all runs of a program; the nodes and endpoints on it are new each time."""

    def made(*arguments: Any) -> Any:
        names = tuple(a if isinstance(a, (str, type)) else None for a in arguments)
        of_node = None if make.__name__ == "Node" else id(arguments[0])
        key = (make.__name__, of_node, names)
        run = _Stage.run
        run.made[key] = number = run.made.get(key, 0) + 1
        if (key, number) not in _Stage.kept:
            _Stage.kept[key, number] = make(*arguments)
        return _Stage.kept[key, number]

    return made


def forget() -> None:
    """Another program comes."""
    gc.collect()
    for (key, _), handle in reversed(_Stage.kept.items()):
        if key[0] != "Node":
            handle.destroy_when_not_in_use()
    for (key, _), handle in _Stage.kept.items():
        if key[0] == "Node":
            handle.destroy_when_not_in_use()
    _Stage.kept.clear()


def _named(start: Callable[..., None]) -> Callable[..., None]:
    def begin(action: Any, node: Any, kind: Any, name: str, *arguments: Any, **options: Any) -> None:
        action.flow_name = name if name.startswith("/") else f"/{name}"
        start(action, node, kind, name, *arguments, **options)

    return begin


def _publish(publisher: Any, message: Any) -> None:
    if publisher.topic_name != "/parameter_events":
        assert isinstance(message, publisher.msg_type)
        _Stage.run.sent(f"topic:{publisher.topic_name}", message)


def _install_clients() -> None:
    def call_async(client: Any, request: Any) -> Future[Any]:
        name, run = client.srv_name, _Stage.run
        run.sent(f"request:{name}", request)
        return run.ask(f"response:{name}", lambda: run.arriving(f"response:{name}", client.srv_type.Response))

    def call(client: Any, request: Any, **_: Any) -> Any:
        name, run = client.srv_name, _Stage.run
        run.sent(f"request:{name}", request)
        return run.arriving(f"response:{name}", client.srv_type.Response)

    Client.call_async, Client.call = call_async, call
    Client.service_is_ready = Client.wait_for_service = lambda *_, **__: True
    ActionClient.server_is_ready = ActionClient.wait_for_server = lambda *_, **__: True
    ActionClient.send_goal_async = _send_goal


def _send_goal(client: Any, goal: Any, feedback_callback: Any = None, **_: Any) -> Future[Any]:
    name, kind, run = client.flow_name, client._action_type, _Stage.run
    run.sent(f"goal:{name}", goal)

    def result() -> Any:
        return SimpleNamespace(status=4, result=run.arriving(f"result:{name}", kind.Result))

    def accepted() -> Any:
        if feedback_callback is not None:
            run.tell(f"feedback:{name}", feedback, lambda message: run.call(feedback_callback, message))
        return SimpleNamespace(accepted=True, get_result_async=lambda: run.ask(f"result:{name}", result))

    def feedback() -> Any:
        return SimpleNamespace(feedback=run.arriving(f"feedback:{name}", kind.Feedback))

    return run.ask("accepted", accepted)
