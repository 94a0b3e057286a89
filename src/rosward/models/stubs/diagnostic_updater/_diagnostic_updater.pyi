# SPDX-License-Identifier: Apache-2.0
"""diagnostic_updater: tasks run when the timer of the updater fires.

Read from ros/diagnostics, branches ros2 and ros2-jazzy (2024-03).
"""

from _rosward import creator, pure, reads_only
from diagnostic_msgs.msg import DiagnosticArray

from diagnostic_updater._diagnostic_status_wrapper import DiagnosticStatusWrapper


@pure
def _array(content, hardware) -> DiagnosticArray: ...


class DiagnosticTask:
    def __init__(self, name):
        self.name = name

    def getName(self):
        return self.name

    def run(self, stat):
        return stat


class FunctionDiagnosticTask(DiagnosticTask):
    def __init__(self, name, fn):
        DiagnosticTask.__init__(self, name)
        self.fn = fn

    def run(self, stat):
        return self.fn(stat)


class CompositeDiagnosticTask(DiagnosticTask):
    def __init__(self, name):
        DiagnosticTask.__init__(self, name)
        self.tasks = []

    def run(self, stat):
        for task in self.tasks:
            stat = task.run(stat)
        return stat

    def addTask(self, t):
        self.tasks.append(t)


@reads_only
class DiagnosticTaskVector:
    def __init__(self):
        self.tasks = []

    def addedTaskCallback(self, task) -> None: ...

    def add(self, *args):
        task = args[0].run if len(args) == 1 else args[1]
        self.tasks.append(task)

    def removeByName(self, name) -> bool: ...


@reads_only
@creator
class Updater(DiagnosticTaskVector):
    def __init__(self, node, period=1.0):
        DiagnosticTaskVector.__init__(self)
        self.node = node
        self.publisher = node.create_publisher(DiagnosticArray, "/diagnostics", 1)
        self.period_parameter = "diagnostic_updater.period"
        self.period = node.declare_parameter(self.period_parameter, period).value
        self.timer = node.create_timer(self.period, self.update)
        self.verbose = False
        self.hwid = ""
        self.use_fqn_parameter = "diagnostic_updater.use_fqn"
        if not node.has_parameter(self.use_fqn_parameter):
            node.declare_parameter(self.use_fqn_parameter, False)

    def update(self):
        for task in self.tasks:
            status = DiagnosticStatusWrapper()
            self.publish((status, task(status)))

    def force_update(self):
        self.update()

    def broadcast(self, lvl, msg):
        self.publish((lvl, msg))

    def setHardwareID(self, hwid):
        self.hwid = hwid

    def publish(self, msg):
        self.publisher.publish(_array(msg, self.hwid))
