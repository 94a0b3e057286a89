# SPDX-License-Identifier: Apache-2.0
"""gpiozero: pins."""

from _rosward import sink, source

sink("device", __name__)

class Button:
    @source("device")
    def when_pressed(self): ...
    @source("device")
    def when_released(self): ...
    @source("device")
    def when_held(self): ...

class MotionSensor:
    @source("device")
    def when_motion(self): ...
    @source("device")
    def when_no_motion(self): ...

class LineSensor:
    @source("device")
    def when_line(self): ...
    @source("device")
    def when_no_line(self): ...

class DistanceSensor:
    @source("device")
    def when_in_range(self): ...
    @source("device")
    def when_out_of_range(self): ...

class DigitalInputDevice:
    @source("device")
    def when_activated(self): ...
    @source("device")
    def when_deactivated(self): ...
