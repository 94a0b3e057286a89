# SPDX-License-Identifier: Apache-2.0
"""rclpy.context: `init` brings the command line (remap rules, parameters) of all nodes.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import calls, init, raises_nothing, reads_only, tried, unknown, waits


class Context:
    _rosward_hidden = (
        "_call_on_shutdown_callbacks", "_callbacks", "_lock", "_logging_fini", "_logging_initialized",
        "_remove_callback", "_abc_impl", "_is_protocol",
    )
    def __init__(self):
        self._nodes = []
        self._begun = False

    @property
    @reads_only
    def handle(self): ...

    @reads_only
    def destroy(self) -> None: ...

    def init(self, args=None, *, initialize_logging=True, domain_id=None):
        if self._begun and tried() and unknown("live", "context of another process", "bool"):
            raise RuntimeError("Context.init() must only be called once")
        self._begun = True
        init(self, args)

    # A node is tracked where the program says what happens when it is destroyed: on any other that changes nothing.

    def track_node(self, node):
        self._nodes.append(node)

    @reads_only
    def untrack_node(self, node) -> None: ...

    def _cleanup(self):
        for node in self._nodes:
            node.destroy_node()
    @raises_nothing
    @waits
    @reads_only
    def ok(self) -> bool: ...
    def shutdown(self):
        self._cleanup()
        self._begun = False

    def try_shutdown(self):
        if self.ok():  # a signal has shut it down before
            self._cleanup()
        self._begun = False

    @calls("callback", event="shutdown", args=())
    def on_shutdown(self, callback) -> None: ...

    @reads_only
    def get_domain_id(self) -> int: ...

    def __enter__(self):
        self.init()
        return self

    def __exit__(self, exc_type, exc_val, exc_tb):
        self.try_shutdown()
