# SPDX-License-Identifier: Apache-2.0
"""launch.launch_context: what a function in a launch file asks the launch.

Read from launch 3.7.0, with what humble had before it.
"""

import os

from _rosward import reads_only, unknown
from _rosward.launch import (
    add_to_configuration,
    configuration,
    configurations,
    has_configuration,
    perform,
    rewrite_configuration,
    set_configuration,
    set_listed,
)

_LISTS = ("global_params", "ros_remaps")


class _Listed(list):
    """What SetParameter or SetRemap have set: what is added to this list holds for all nodes from then on."""

    def __init__(self, name):
        super().__init__(configuration(name))
        self._name = name

    def append(self, item):
        super().append(item)
        add_to_configuration(self._name, item)

    def extend(self, items):
        for item in items:
            self.append(item)

    def __iadd__(self, items):
        self.extend(items)
        return self

    def __setitem__(self, index, item):
        super().__setitem__(index, item)
        self._rewrite()

    def __delitem__(self, index):
        super().__delitem__(index)
        self._rewrite()

    def insert(self, index, item):
        super().insert(index, item)
        self._rewrite()

    def remove(self, item):
        super().remove(item)
        self._rewrite()

    def pop(self, index=-1):
        item = super().pop(index)
        self._rewrite()
        return item

    def clear(self):
        super().clear()
        self._rewrite()

    def sort(self, *, key=None, reverse=False):
        super().sort(key=key, reverse=reverse)
        self._rewrite()

    def reverse(self):
        super().reverse()
        self._rewrite()

    def _rewrite(self):
        rewrite_configuration(self._name, list(self))

    def __copy__(self): return list(self)
    def __deepcopy__(self, memo): return list(self)


class _Configurations:
    """`context.launch_configurations`."""

    def __getitem__(self, key): return _Listed(key) if key in _LISTS else configuration(key)

    def get(self, key, default=None):
        if key in _LISTS:
            return _Listed(key) if has_configuration(key) else default
        return configuration(key, default)

    def __setitem__(self, key, value):
        if key not in _LISTS:
            set_configuration(key, value)
        elif not isinstance(value, _Listed):
            set_listed(key, value)

    def __delitem__(self, key): set_configuration(key, None)
    def __contains__(self, key): return has_configuration(key)
    def __iter__(self): return iter(configurations())
    def __len__(self): return len(configurations())
    def keys(self): return configurations().keys()
    def values(self): return configurations().values()
    def items(self): return configurations().items()
    def copy(self): return configurations()

    def setdefault(self, key, default=None):
        if key not in _LISTS:
            value = configuration(key, default)
            set_configuration(key, value)
            return value
        if not has_configuration(key):
            set_listed(key, default)
        return _Listed(key)

    def pop(self, key, *default):
        value = self.get(key, *default) if default else self[key]
        set_configuration(key, None)
        return value

    def update(self, *others, **given):
        for key, value in dict(*others, **given).items():
            self[key] = value

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
