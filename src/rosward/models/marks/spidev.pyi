# SPDX-License-Identifier: Apache-2.0
"""spidev: a bus."""

from _rosward import sink, source

class SpiDev:
    @sink("device")
    @source("device")
    def xfer(self, values, *args): ...
    @sink("device")
    @source("device")
    def xfer2(self, values, *args): ...
    @sink("device")
    @source("device")
    def xfer3(self, values, *args): ...
    @sink("device")
    def writebytes(self, values): ...
    @source("device")
    def readbytes(self, length): ...
