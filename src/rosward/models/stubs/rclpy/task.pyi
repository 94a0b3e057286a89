# SPDX-License-Identifier: Apache-2.0
"""rclpy.task: a future holds what it was given; its callbacks may run with it.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import awaited, reads_only, schedule, suspends, unknown

reads_only(__name__)


class Future:
    def __init__(self, *, executor=None):
        self._result = None
        self._exception = None

    @suspends
    def __await__(self):
        yield None
        return self.result()

    def cancel(self) -> None: ...
    def cancelled(self) -> bool: ...
    def done(self) -> bool: ...

    def result(self):
        if self._exception is not None:
            raise self._exception
        return self._result

    def exception(self):
        if self._exception is not None:
            return self._exception
        return unknown("live", "rclpy.task.Future.exception")

    def set_result(self, result):
        self._result = result

    def set_exception(self, exception):
        self._exception = exception

    def add_done_callback(self, callback):
        schedule(callback, self, event="future")

    def remove_done_callback(self, callback) -> bool: ...


class Task(Future):
    def __init__(self, handler, args=None, kwargs=None, executor=None):
        super().__init__(executor=executor)
        self._handler = handler
        self._args = () if args is None else args
        self._kwargs = {} if kwargs is None else kwargs

    def __call__(self):
        # A coroutine is awaited: one that is handed over, and one that a coroutine function makes of the arguments.
        if callable(self._handler):
            self.set_result(awaited(self._handler(*self._args, **self._kwargs)))
        else:
            self.set_result(awaited(self._handler))

    def executing(self) -> bool: ...
    def cancel(self) -> None: ...
