# SPDX-License-Identifier: Apache-2.0
"""copy: its models in code."""

from _rosward import pure

pure(__name__)
