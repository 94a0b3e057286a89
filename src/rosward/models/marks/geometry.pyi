# SPDX-License-Identifier: Apache-2.0
"""geometry: geometry."""

from _rosward import pure

pure(__name__)
