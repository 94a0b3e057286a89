# SPDX-License-Identifier: Apache-2.0
"""playsound."""

from _rosward import sink

@sink("device")
def playsound(sound, block=True): ...
