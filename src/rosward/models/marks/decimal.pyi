# SPDX-License-Identifier: Apache-2.0
"""decimal: numbers."""

from _rosward import pure

pure(__name__)
