# SPDX-License-Identifier: Apache-2.0
"""`pkgutil`: what is in a package. Which modules a folder holds is not looked up. Read in CPython 3.13, `Lib/pkgutil.py`."""
from importlib.resources import files
from _rosward import reads_only, source

@source("file")
def get_data(package, resource):
    return files(package).joinpath(resource).read_bytes()
@reads_only
def iter_modules(path=None, prefix=''): ...
@reads_only
def walk_packages(path=None, prefix='', onerror=None): ...
@reads_only
def extend_path(path, name): ...
@reads_only
def find_loader(fullname): ...
@reads_only
def get_loader(module_or_name): ...
@reads_only
def resolve_name(name): ...
