# SPDX-License-Identifier: Apache-2.0
"""busio: buses of CircuitPython."""

from _rosward import changes, sink, source

class I2C:
    @sink("device")
    def writeto(self, address, buffer, **kwargs): ...
    @changes("buffer")
    @source("device")
    def readfrom_into(self, address, buffer, **kwargs): ...
