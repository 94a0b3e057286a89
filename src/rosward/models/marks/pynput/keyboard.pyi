# SPDX-License-Identifier: Apache-2.0
"""pynput: what a person does with the keyboard."""

from _rosward import source

@source("device")
class Listener: ...
