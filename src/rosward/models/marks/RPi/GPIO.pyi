# SPDX-License-Identifier: Apache-2.0
"""RPi.GPIO: pins."""

from _rosward import sink, source

@sink("device")
def output(channel, value): ...
@source("device")
def input(channel): ...

class PWM:
    @sink("device")
    def start(self, duty_cycle): ...
    @sink("device")
    def ChangeDutyCycle(self, duty_cycle): ...
    @sink("device")
    def ChangeFrequency(self, frequency): ...
