# SPDX-License-Identifier: Apache-2.0
"""marshal: objects as bytes, which execute what they like when they are read."""

from _rosward import sink

@sink("pickle")
def loads(data, /): ...
@sink("pickle")
def load(file, /): ...
