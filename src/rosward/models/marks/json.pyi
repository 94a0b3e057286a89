# SPDX-License-Identifier: Apache-2.0
"""`json`: its models in code."""

from _rosward import source

@source("file")
def load(fp, **kw): ...
