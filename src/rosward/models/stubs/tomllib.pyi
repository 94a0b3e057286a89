# SPDX-License-Identifier: Apache-2.0
"""`tomllib`: text that stands in the program, or in a file of the sources, is read (models/python/std/data.py)."""
from _rosward import native

class TOMLDecodeError(ValueError): ...

@native
def load(fp, /, *, parse_float=float): ...
@native
def loads(s, /, *, parse_float=float): ...
