# SPDX-License-Identifier: Apache-2.0
"""pygame.mouse."""

from _rosward import source

@source("device")
def get_pressed(num_buttons=3): ...
@source("device")
def get_pos(): ...
@source("device")
def get_rel(): ...
