# SPDX-License-Identifier: Apache-2.0
"""What happens to a program while it spins? Everything once: messages, requests, timers, goals, parameters, transitions.

    node.create_subscription(String, "in", on_message, 10); rclpy.spin(node)    -> on_message(String()), and spin returns

The callbacks are called by the place where the program spins, so the order is the same each time; nothing goes over the middleware.
Spinning ends when all that was there has happened a few times: `spin` then returns, or an interrupt comes as by Ctrl-C.
"""

from __future__ import annotations

import inspect
import os
import signal
import threading
import time
import weakref
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any, Final

import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.executors import Executor, SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from rclpy.subscription import Subscription

from .goals import answer_goals, serve_goals
from .recorder import Recorder

ROUNDS: Final = 3
IDLE: Final = 40
"""How often a program may sleep or ask whether it still runs, after everything has happened."""


class World:
    """Lets everything happen that can. `interrupt` says how spinning ends: by Ctrl-C or by returning."""

    def __init__(self, recorder: Recorder, *, interrupt: bool) -> None:
        self.errors: list[str] = []
        self.over = False
        self._recorder = recorder
        self._interrupt = interrupt
        self._nodes: list[weakref.ref[Node]] = []
        self._busy = threading.Lock()
        self._idle = 0
        self._seen = -1
        self._goals = 0
        self._spin_once: dict[type, Callable[..., None]] = {}

    @property
    def nodes(self) -> list[Any]:
        """The nodes of the program that are alive."""
        return [node for ref in self._nodes if (node := ref()) is not None]

    def happen(self, executor: Any = None) -> None:
        """Call every callback of every node, and again while that brings new ones."""
        if not self._busy.acquire(blocking=False):
            return
        try:
            for _ in range(ROUNDS):
                self._recorder.read_all()
                known = len(self._recorder.facts) + len(self._recorder.nodes)
                if known == self._seen:
                    break
                self._seen = known
                for node in self.nodes:
                    for callback, *arguments in list(_callbacks(node)):
                        self._call(callback, *arguments)
                    for server in [w for w in node.waitables if isinstance(w, ActionServer)]:
                        self._goals += 1
                        self._call(serve_goals, server, self._goals, self._call)
                for _ in range(3):
                    self._turn(executor)
                    self.complete()
            self._recorder.read_all()
        finally:
            self._busy.release()

    def complete(self) -> None:
        """Answer every request that waits."""
        for node in self.nodes:
            for client in list(node.clients):
                for future in list(client._pending_requests.values()):
                    if not future.done():
                        self._call(future.set_result, client.srv_type.Response())
            for client in [w for w in node.waitables if isinstance(w, ActionClient)]:
                answer_goals(client, self._call)

    def _turn(self, executor: Any) -> None:
        spin_once = self._spin_once.get(SingleThreadedExecutor)
        if executor is not None and spin_once is not None:
            cls = type(executor)
            own = cls.spin_once if any("spin_once" in vars(c) for c in cls.mro() if c not in self._spin_once) else None
            self._call(own or self._spin_once.get(cls, spin_once), executor, 0.002)

    def _call(self, callback: Callable[..., Any], *arguments: Any) -> None:
        try:
            result = callback(*arguments)
            if inspect.iscoroutine(result):
                for _ in range(20):
                    result.send(None)
                    self.complete()
                result.close()
        except StopIteration:
            pass
        except (Exception, SystemExit) as error:
            self.errors.append(f"{type(error).__name__}: {error}")

    # Where the program waits

    def install(self) -> None:
        """From now on what waits comes here."""
        self._watch_nodes()
        self._watch_spinning()
        self._watch_waiting()

    def _watch_nodes(self) -> None:
        start = Node.__init__

        def noted(node: Any, *args: Any, **options: Any) -> None:
            self._nodes.append(weakref.ref(node))
            start(node, *args, **options)

        Node.__init__ = noted

    def _watch_spinning(self) -> None:
        originals = (Executor.spin, Executor.spin_until_future_complete)

        def spin(executor: Any) -> None:
            self.happen(executor)
            for _ in range(3):
                self._turn(executor)
            if self._interrupt and threading.current_thread() is threading.main_thread():
                os.kill(os.getpid(), signal.SIGINT)
                originals[0](executor)

        def spin_node(node: Any, executor: Any = None) -> None:
            executor = rclpy.get_global_executor() if executor is None else executor
            executor.add_node(node)
            try:
                executor.spin()
            finally:
                executor.remove_node(node)

        def spin_until(executor: Any, future: Any, timeout_sec: float | None = None) -> None:
            self.happen(executor)
            for _ in range(3):
                self._turn(executor)
            self.complete()
            originals[1](executor, future, 0.2 if timeout_sec is None else min(timeout_sec, 0.2))

        for cls in (Executor, SingleThreadedExecutor, rclpy.executors.MultiThreadedExecutor):
            self._spin_once[cls] = cls.spin_once
        Executor.spin, Executor.spin_until_future_complete, rclpy.spin = spin, spin_until, spin_node
        for cls in (SingleThreadedExecutor, rclpy.executors.MultiThreadedExecutor):
            cls.spin_once = self._spin_once_of(cls)

    def _spin_once_of(self, cls: type) -> Callable[..., None]:
        def spin_once(executor: Any, timeout_sec: float | None = None) -> None:
            self.happen(executor)
            self._call(self._spin_once[cls], executor, 0.002 if timeout_sec is None else min(timeout_sec, 0.002))
            self._wait()

        return spin_once

    def _watch_waiting(self) -> None:
        sleep, ok = time.sleep, rclpy.ok

        def still(*, context: Any = None) -> bool:
            self._wait()
            return ok(context=context) and not self.over

        def nap(seconds: Any) -> None:
            self._wait()
            sleep(min(seconds, 0.001))

        time.sleep = nap
        rclpy.ok = rclpy.utilities.ok = still
        rclpy.timer.Rate.sleep = lambda _: nap(0.0)
        rclpy.client.Client.service_is_ready = lambda _: True
        rclpy.client.Client.wait_for_service = _is_there
        rclpy.client.Client.call = _answered
        ActionClient.server_is_ready = lambda _: True
        ActionClient.wait_for_server = _is_there

    def _wait(self) -> None:
        """One more turn in which nothing is left to happen."""
        self._idle += 1
        if self._idle > IDLE:
            self.over = True
        if self._idle > 4 * IDLE:
            raise KeyboardInterrupt if threading.current_thread() is threading.main_thread() else SystemExit


def _is_there(_client: Any, timeout_sec: float | None = None) -> bool:  # noqa: ARG001
    return True


def _answered(client: Any, request: Any, timeout_sec: float | None = None) -> Any:  # noqa: ARG001
    return client.srv_type.Response()


def _callbacks(node: Any) -> Iterable[tuple[Any, ...]]:
    """Every callback of the program's own that hangs on a node, with what the client library would give it."""
    for timer in node.timers:
        known = _wants_information(timer.callback)
        yield (partial(timer.callback, **{known: rclpy.timer.TimerInfo()}) if known else timer.callback,)
    for subscription in node.subscriptions:
        if not _of_library(subscription.callback):
            message = b"" if subscription.raw else subscription.msg_type()
            plain = subscription._callback_type is Subscription.CallbackType.MessageOnly
            yield subscription.callback, message, *([] if plain else [{"source_timestamp": 0}])
    for service in node.services:
        if not _of_library(service.callback):
            yield service.callback, service.srv_type.Request(), service.srv_type.Response()
    for guard in node.guards:
        if guard.callback is not None and not _of_library(guard.callback):
            yield (guard.callback,)
    if any(
        not _of_library(callback)
        for kind in ("pre_set", "on_set", "post_set")
        for callback in getattr(node, f"_{kind}_parameters_callbacks")
    ):
        yield node.set_parameters, [p for p in node._parameters.values() if p.value is not None]
    if isinstance(node, LifecycleNode):
        for step in ("configure", "activate", "deactivate", "cleanup", "configure", "activate"):
            yield (getattr(node, f"trigger_{step}"),)


def _of_library(callback: Any) -> bool:
    return str(getattr(callback, "__module__", "")).startswith("rclpy.")


def _wants_information(callback: Any) -> str | None:
    """The parameter of a timer's callback that takes the times of the call."""
    try:
        parameters = inspect.signature(callback).parameters.values()
    except (TypeError, ValueError):
        return None
    return next((p.name for p in parameters if "TimerInfo" in str(p.annotation)), None)
