# SPDX-License-Identifier: Apache-2.0
"""utm: geometry."""

from _rosward import pure

pure(__name__)
