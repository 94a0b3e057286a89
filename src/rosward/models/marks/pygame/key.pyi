# SPDX-License-Identifier: Apache-2.0
"""pygame.key."""

from _rosward import source

@source("device")
def get_pressed(): ...
@source("device")
def get_mods(): ...
