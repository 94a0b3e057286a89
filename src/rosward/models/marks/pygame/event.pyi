# SPDX-License-Identifier: Apache-2.0
"""pygame.event: keys, mice and joysticks."""

from _rosward import source

@source("device")
def get(eventtype=None, pump=True, exclude=None): ...
@source("device")
def poll(): ...
@source("device")
def wait(timeout=0): ...
