# SPDX-License-Identifier: Apache-2.0
"""pigpio: pins."""

from _rosward import sink, source

class pi:
    @sink("device")
    def write(self, gpio, level): ...
    @sink("device")
    def set_servo_pulsewidth(self, user_gpio, pulsewidth): ...
    @sink("device")
    def set_PWM_dutycycle(self, user_gpio, dutycycle): ...
    @source("device")
    def read(self, gpio): ...
