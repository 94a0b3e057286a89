# SPDX-License-Identifier: Apache-2.0
"""`importlib.machinery`: what loads the module of a file. Read in CPython 3.13, `Lib/importlib/_bootstrap_external.py`."""
import os
from _rosward import native, reads_only, unknown

@native
def _module_at(name, path): ...

class ModuleSpec:
    submodule_search_locations = None
    def __init__(self, name, loader, *, origin=None, loader_state=None, is_package=None):
        self.name = name
        self.loader = loader
        self.origin = origin
class SourceFileLoader:
    def __init__(self, fullname, path):
        self.name = fullname
        self.path = os.fspath(path)
    def load_module(self, fullname=None):
        return _module_at(self.name, self.path)
    @reads_only
    def exec_module(self, module) -> None: ...
    @reads_only
    def create_module(self, spec) -> None: ...
class FileFinder:
    def __init__(self, path, *loader_details):
        self.path = path
    def _loader(self, fullname):
        import pkgutil
        last = fullname.rpartition('.')[2]
        inside = pkgutil._modules(self.path)
        if inside is None:
            return unknown('call', 'a finder of modules')
        for name, package in inside:
            if name == last:
                return SourceFileLoader(fullname, os.path.join(self.path, last, '__init__.py') if package else os.path.join(self.path, last + '.py'))
        return None
    def find_spec(self, fullname, target=None):
        loader = self._loader(fullname)
        return None if loader is None else ModuleSpec(fullname, loader, origin=loader.path)
    def find_module(self, fullname):
        return self._loader(fullname)
    @reads_only
    def invalidate_caches(self):
        pass
