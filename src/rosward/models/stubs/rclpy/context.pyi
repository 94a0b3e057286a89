# SPDX-License-Identifier: Apache-2.0
"""rclpy.context: `init` brings the command line (remap rules, parameters) of all nodes.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import calls, native


@native
def _use_arguments(args) -> None: ...


class Context:
    def __init__(self) -> None: ...

    @property
    def handle(self): ...

    def destroy(self) -> None: ...

    def init(self, args=None, *, initialize_logging=True, domain_id=None):
        _use_arguments(args)

    def track_node(self, node) -> None: ...
    def untrack_node(self, node) -> None: ...
    def ok(self) -> bool: ...
    def shutdown(self) -> None: ...
    def try_shutdown(self) -> None: ...

    @calls("callback", event="shutdown", args=())
    def on_shutdown(self, callback) -> None: ...

    def get_domain_id(self) -> int: ...

    def __enter__(self):
        self.init()
        return self

    def __exit__(self, exc_type, exc_val, exc_tb) -> None: ...
