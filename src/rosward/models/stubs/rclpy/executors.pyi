# SPDX-License-Identifier: Apache-2.0
"""rclpy.executors: every `spin*` lets run what is registered; `create_task` registers.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import ask, beside, reads_only, schedule, spins, spun, unknown

from rclpy.context import Context
from rclpy.task import Future as Future, Task as Task


async def await_or_execute(callback, *args):
    return callback(*args)


class TimeoutException(Exception): ...


class ShutdownException(Exception): ...


class ExternalShutdownException(Exception): ...


class ConditionReachedException(Exception): ...


class TimeoutObject:
    def __init__(self, timeout):
        self.timeout = timeout


class Executor:
    _rosward_hidden = (
        "_cb_iter", "_clock", "_context", "_executor", "_futures", "_guard", "_is_protocol", "_abc_impl",
        "_is_shutdown", "_last_args", "_last_kwargs", "_make_handler", "_nodes", "_nodes_lock", "_shutdown_lock",
        "_sigint_gc", "_spin_once_impl", "_spin_once_until_future_complete", "_take_client",
        "_take_guard_condition", "_take_service", "_take_subscription", "_take_timer", "_take_waitable", "_tasks",
        "_tasks_lock", "_wait_for_ready_callbacks", "_work_tracker",
    )
    _nodes = None  # of an executor that the program did not make (`node.executor`), its nodes are not known
    def __init__(self, *, context=None):
        self._nodes = []
        if type(self) is not SingleThreadedExecutor:  # several threads, or a class of the program, which may start some
            beside()
        ask(self, "wake")

    @property
    @reads_only
    def context(self) -> Context: ...

    def create_task(self, callback, *args, **kwargs):
        task = Task(callback, args, kwargs, executor=self)
        schedule(task, event="task")
        return task

    def create_future(self):
        return Future(executor=self)

    @reads_only
    def shutdown(self, timeout_sec=None) -> bool: ...

    def add_node(self, node):
        spun(node)
        if self._nodes is None:
            return unknown("live", "rclpy.executors.Executor.add_node", "bool")
        if any(each is node for each in self._nodes):
            return False
        self._nodes.append(node)
        return True

    def remove_node(self, node):
        if self._nodes is not None and node in self._nodes:
            self._nodes.remove(node)

    @reads_only
    def wake(self) -> None: ...

    def get_nodes(self):
        return unknown("live", "rclpy.executors.Executor.get_nodes", "list") if self._nodes is None else self._nodes

    @spins
    def spin(self):
        ask(self, "spin_once")
        ask(self, "get_nodes")
        ask(self, "can_execute", unknown("live", "entity that is ready"))

    @spins
    def spin_until_future_complete(self, future, timeout_sec=None):
        ask(self, "wake")
        ask(self, "get_nodes")
        ask(self, "can_execute", unknown("live", "entity that is ready"))

    @spins
    def spin_once(self, timeout_sec=None):
        ask(self, "get_nodes")
        ask(self, "can_execute", unknown("live", "entity that is ready"))

    @spins
    def spin_once_until_future_complete(self, future, timeout_sec=None):
        ask(self, "get_nodes")
        ask(self, "can_execute", unknown("live", "entity that is ready"))

    @reads_only
    def can_execute(self, entity) -> bool: ...

    @spins
    def wait_for_ready_callbacks(self, *args, **kwargs): ...

    def __enter__(self):
        return self

    def __exit__(self, exc_type, exc_val, exc_tb):
        ask(self, "shutdown")


class SingleThreadedExecutor(Executor):
    _rosward_hidden = (
        "_cb_iter",
    )
    def __init__(self, *, context=None):
        super().__init__(context=context)

    @spins
    def spin_once(self, timeout_sec=None):
        ask(self, "get_nodes")
        ask(self, "can_execute", unknown("live", "entity that is ready"))

    @spins
    def spin_once_until_future_complete(self, future, timeout_sec=None):
        ask(self, "get_nodes")
        ask(self, "can_execute", unknown("live", "entity that is ready"))


class MultiThreadedExecutor(Executor):
    _rosward_hidden = (
        "_cb_iter",
    )
    def __init__(self, num_threads=None, *, context=None):
        super().__init__(context=context)

    @spins
    def spin_once(self, timeout_sec=None):
        ask(self, "get_nodes")
        ask(self, "can_execute", unknown("live", "entity that is ready"))

    @spins
    def spin_once_until_future_complete(self, future, timeout_sec=None):
        ask(self, "get_nodes")
        ask(self, "can_execute", unknown("live", "entity that is ready"))

    @reads_only
    def shutdown(self, timeout_sec=None, *, wait_for_threads=True) -> bool: ...
