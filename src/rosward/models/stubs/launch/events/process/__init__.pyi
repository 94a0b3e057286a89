# SPDX-License-Identifier: Apache-2.0
"""launch.events.process.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only, unknown
from launch.event import Event

reads_only(__name__)


class RunningProcessEvent(Event):
    def __init__(self, **kwargs): ...


class ProcessStarted(RunningProcessEvent): ...


class ProcessExited(RunningProcessEvent):
    @property
    def returncode(self): return unknown("live", "exit code of a process", "int")


class ProcessIO(RunningProcessEvent):
    @property
    def text(self): return unknown("input", "output of a process", "bytes")


class ProcessStdin(ProcessIO): ...
class ProcessStdout(ProcessIO): ...
class ProcessStderr(ProcessIO): ...


class ProcessTargetedEvent(Event):
    def __init__(self, *, process_matcher): ...


class ShutdownProcess(ProcessTargetedEvent): ...


class SignalProcess(Event):
    def __init__(self, *, signal_number, process_matcher): ...


def matches_pid(pid): ...
def matches_name(name): ...
def matches_executable(executable): ...
