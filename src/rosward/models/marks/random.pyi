# SPDX-License-Identifier: Apache-2.0
"""`random`."""

from _rosward import changes, source

source("random", __name__)

@changes("x")
@source("random")
def shuffle(x): ...

class Random:
    @changes("x")
    @source("random")
    def shuffle(self, x): ...
