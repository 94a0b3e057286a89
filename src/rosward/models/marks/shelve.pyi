# SPDX-License-Identifier: Apache-2.0
"""shelve: objects in a file, which execute what they like when they are read."""

from _rosward import sink

@sink("pickle")
def open(filename): ...
