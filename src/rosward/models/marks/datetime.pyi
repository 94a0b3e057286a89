# SPDX-License-Identifier: Apache-2.0
"""`datetime`: what the clock says, and computing with it."""

from _rosward import pure, source

pure(__name__)

class date:
    @source("clock")
    def today(): ...

class datetime(date):
    @source("clock")
    def now(tz=None): ...
    @source("clock")
    def utcnow(): ...
