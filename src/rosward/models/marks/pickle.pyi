# SPDX-License-Identifier: Apache-2.0
"""`pickle`: objects as bytes, which execute what they like when they are read."""

from _rosward import sink

class Unpickler:
    @sink("pickle")
    def load(self): ...
