# SPDX-License-Identifier: Apache-2.0
"""odrive: motors."""

from _rosward import sink

sink("device", __name__)
