# SPDX-License-Identifier: Apache-2.0
"""jsonpickle: objects as text, which execute what they like when they are read."""

from _rosward import sink

@sink("pickle")
def decode(string): ...
