# SPDX-License-Identifier: Apache-2.0
"""numpy.random."""

from _rosward import changes, source

source("random", __name__)

@changes("x")
@source("random")
def shuffle(x): ...

@source("random")
class Generator:
    @changes("x")
    @source("random")
    def shuffle(self, x, axis=0): ...

def default_rng(seed=None) -> Generator: ...
