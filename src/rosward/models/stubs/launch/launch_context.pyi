# SPDX-License-Identifier: Apache-2.0
"""launch.launch_context: what a function in a launch file asks the launch.

Read from launch 3.7.0, with what humble had before it.
"""

import os

from _rosward import reads_only, unknown
from _rosward.launch import configuration, configurations, has_configuration, perform, set_configuration


class _Configurations:
    """`context.launch_configurations`."""

    def __getitem__(self, key): return configuration(key)
    def get(self, key, default=None): return configuration(key, default)
    def __setitem__(self, key, value): set_configuration(key, value)
    def __delitem__(self, key): set_configuration(key, None)
    def __contains__(self, key): return has_configuration(key)
    def __iter__(self): return iter(configurations())
    def __len__(self): return len(configurations())
    def keys(self): return configurations().keys()
    def values(self): return configurations().values()
    def items(self): return configurations().items()
    def copy(self): return configurations()

    def setdefault(self, key, default=None):
        value = configuration(key, default)
        set_configuration(key, value)
        return value

    def pop(self, key, *default):
        value = configuration(key, *default)
        set_configuration(key, None)
        return value

    def update(self, *others, **given):
        for key, value in dict(*others, **given).items():
            set_configuration(key, value)

    def clear(self):
        for key in configurations():
            set_configuration(key, None)


_ALL = _Configurations()


@reads_only
class LaunchContext:
    def __init__(self, *, argv=None, noninteractive=False): ...

    @property
    def launch_configurations(self): return _ALL
    @property
    def environment(self): return os.environ
    @property
    def argv(self): return unknown("argument", "argv", "list")
    @property
    def noninteractive(self): return unknown("argument", "noninteractive", "bool")
    @property
    def is_shutdown(self): return unknown("live", "whether launch shuts down", "bool")
    @property
    def locals(self): return unknown("input", "event")
    def get_locals_as_dict(self): return unknown("input", "event", "dict")
    def extend_globals(self, extensions): ...
    def extend_locals(self, extensions): ...
    def perform_substitution(self, substitution): return perform(substitution)
    def add_completion_future(self, completion_future) -> None: ...
    def would_handle_event(self, event) -> bool: ...
    def register_event_handler(self, event_handler, append=False) -> None: ...
    def unregister_event_handler(self, event_handler) -> None: ...
    def emit_event_sync(self, event) -> None: ...
    async def emit_event(self, event) -> None: ...
