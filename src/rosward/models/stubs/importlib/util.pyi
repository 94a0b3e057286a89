# SPDX-License-Identifier: Apache-2.0
"""`importlib.util`: modules by their paths, see models/python/builtins/import_by_name.py. Read in CPython 3.13, `Lib/importlib/util.py`.

The module runs where it is made of its specification, each time anew.
"""
import os
from _rosward import reads_only
from importlib.machinery import ModuleSpec as ModuleSpec, SourceFileLoader, _module_at

def spec_from_file_location(name, location=None, *, loader=None, submodule_search_locations=None):
    path = location if location is not None else loader.path
    return ModuleSpec(name, loader or SourceFileLoader(name, path), origin=os.fspath(path))
def spec_from_loader(name, loader, *, origin=None, is_package=None):
    return ModuleSpec(name, loader, origin=loader.path)
def module_from_spec(spec):
    return _module_at(spec.name, spec.origin)
@reads_only
def resolve_name(name, package) -> str: ...
@reads_only
def find_spec(name, package=None): ...
