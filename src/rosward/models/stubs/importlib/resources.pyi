# SPDX-License-Identifier: Apache-2.0
"""`importlib.resources`: files beside the modules of a package. Read in CPython 3.13, `Lib/importlib/resources/_functional.py`."""
import importlib
import os
import pathlib
from _rosward import reads_only, source

def files(anchor):
    module = importlib.import_module(anchor) if isinstance(anchor, str) else anchor
    return pathlib.Path(os.path.dirname(module.__file__))

class as_file:
    """A path is a file already."""
    def __init__(self, path):
        self._path = path
    def __enter__(self):
        return self._path
    def __exit__(self, *error):
        return None

def path(anchor, *path_names):
    return as_file(files(anchor).joinpath(*path_names))
@source("file")
def read_text(anchor, *path_names, encoding='utf-8', errors='strict'):
    return files(anchor).joinpath(*path_names).read_text()
@source("file")
def read_binary(anchor, *path_names):
    return files(anchor).joinpath(*path_names).read_bytes()
def open_text(anchor, *path_names, encoding='utf-8', errors='strict'):
    return files(anchor).joinpath(*path_names).open('r')
def open_binary(anchor, *path_names):
    return files(anchor).joinpath(*path_names).open('rb')
def is_resource(anchor, *path_names):
    return files(anchor).joinpath(*path_names).is_file()
@reads_only
@source("file")
def contents(anchor, *path_names): ...
