# SPDX-License-Identifier: Apache-2.0
"""`importlib`: modules by their names, see models/python/builtins/import_by_name.py. Of its other modules, `machinery`, `resources` and `util` have models."""
from _rosward import native, reads_only

@native
def import_module(name, package=None): ...
@native
def reload(module): ...
@reads_only
def invalidate_caches() -> None: ...
