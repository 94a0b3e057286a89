# SPDX-License-Identifier: Apache-2.0
"""textwrap: texts."""

from _rosward import pure

pure(__name__)
