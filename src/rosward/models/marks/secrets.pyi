# SPDX-License-Identifier: Apache-2.0
"""`secrets`."""

from _rosward import source

source("random", __name__)
