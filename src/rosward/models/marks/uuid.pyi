# SPDX-License-Identifier: Apache-2.0
"""`uuid`: those that differ each time."""

from _rosward import source

@source("random")
def uuid1(node=None, clock_seq=None): ...
@source("random")
def uuid4(): ...
