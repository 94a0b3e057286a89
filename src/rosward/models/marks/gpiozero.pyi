# SPDX-License-Identifier: Apache-2.0
"""gpiozero: pins."""

from _rosward import sink

sink("device", __name__)
