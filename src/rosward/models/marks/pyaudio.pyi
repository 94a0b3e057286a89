# SPDX-License-Identifier: Apache-2.0
"""PyAudio: microphones and loudspeakers."""

from _rosward import sink, source

class Stream:
    @source("device")
    def read(self, num_frames, exception_on_overflow=True): ...
    @sink("device")
    def write(self, frames, num_frames=None, exception_on_underflow=False): ...

class PyAudio:
    @source("device")  # a callback of the stream gets what a microphone hears
    def open(self, *args, **kwargs) -> Stream: ...
