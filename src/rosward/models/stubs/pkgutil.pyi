# SPDX-License-Identifier: Apache-2.0
"""`pkgutil`: what is in a package. Read in CPython 3.13, `Lib/pkgutil.py`.

The modules of a folder are those of the sources.
"""
from importlib.resources import files
from _rosward import native, reads_only, source, unknown
from collections import namedtuple
from importlib.machinery import FileFinder
import importlib

ModuleInfo = namedtuple('ModuleInfo', 'module_finder name ispkg')

@source("file")
def get_data(package, resource):
    return files(package).joinpath(resource).read_bytes()

@native
def _modules(folder): ...

def _some(prefix):
    finder = unknown('call', 'a finder of modules')
    return [ModuleInfo(finder, prefix + unknown('call', 'pkgutil.iter_modules', 'str'), unknown('call', 'pkgutil.iter_modules', 'bool'))
            for _ in unknown('call', 'pkgutil.iter_modules', 'list')]

def iter_modules(path=None, prefix=''):
    if path is None:
        return iter(_some(prefix))
    found = []
    for folder in path:
        inside = _modules(folder)
        if inside is None:
            found += _some(prefix)
        else:
            finder = FileFinder(folder)
            found += [ModuleInfo(finder, prefix + name, package) for name, package in inside]
    return iter(found)

def walk_packages(path=None, prefix='', onerror=None):
    for info in iter_modules(path, prefix):
        yield info
        if path is not None and info.ispkg:
            module = importlib.import_module(info.name)
            yield from walk_packages(module.__path__, info.name + '.', onerror)

@reads_only
def extend_path(path, name): ...
@reads_only
def find_loader(fullname): ...
@reads_only
def get_loader(module_or_name): ...
def resolve_name(name):
    module, colon, rest = name.partition(':')
    if not colon:
        return unknown('call', 'pkgutil.resolve_name')
    found = importlib.import_module(module)
    for part in rest.split('.') if rest else []:
        found = getattr(found, part)
    return found
