# SPDX-License-Identifier: Apache-2.0
"""inputs: keyboards, mice and gamepads."""

from _rosward import source

source("device", __name__)

def get_gamepad(): ...
def get_key(): ...
def get_mouse(): ...
