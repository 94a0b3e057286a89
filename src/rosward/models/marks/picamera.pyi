# SPDX-License-Identifier: Apache-2.0
"""picamera: a camera."""

from _rosward import source

source("device", __name__)
