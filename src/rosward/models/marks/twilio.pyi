# SPDX-License-Identifier: Apache-2.0
"""twilio: short messages."""

from _rosward import sink

sink("network", __name__)
