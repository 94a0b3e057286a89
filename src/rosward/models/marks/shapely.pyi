# SPDX-License-Identifier: Apache-2.0
"""shapely: geometry."""

from _rosward import pure

pure(__name__)
