# SPDX-License-Identifier: Apache-2.0
"""`importlib`: which module is executed."""

from _rosward import sink

@sink("code")
def import_module(name, package=None): ...
