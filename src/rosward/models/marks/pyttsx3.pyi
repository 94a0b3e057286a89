# SPDX-License-Identifier: Apache-2.0
"""pyttsx3: speech."""

from _rosward import sink

class Engine:
    @sink("device")
    def say(self, text, name=None): ...

def init(driverName=None, debug=False) -> Engine: ...
