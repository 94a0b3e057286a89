# SPDX-License-Identifier: Apache-2.0
"""psutil: the state of the computer."""

from _rosward import source

source("device", __name__)
