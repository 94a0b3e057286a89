# SPDX-License-Identifier: Apache-2.0
"""telegram: messages of Telegram."""

from _rosward import sink

sink("network", __name__)
