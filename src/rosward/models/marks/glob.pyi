# SPDX-License-Identifier: Apache-2.0
"""`glob`: which files there are."""

from _rosward import source

@source("file")
def glob(pathname, **kw): ...
@source("file")
def iglob(pathname, **kw): ...
