# SPDX-License-Identifier: Apache-2.0
"""sounddevice: microphones and loudspeakers."""

from _rosward import sink, source

@source("device")
def rec(frames=None, *args, **kwargs): ...
@sink("device")
def play(data, *args, **kwargs): ...
@sink("device")
@source("device")
def playrec(data, *args, **kwargs): ...
@source("device")
class InputStream:
    def read(self, frames): ...
@source("device")
class RawInputStream:
    def read(self, frames): ...
class OutputStream:
    @sink("device")
    def write(self, data): ...
class RawOutputStream:
    @sink("device")
    def write(self, data): ...
