# SPDX-License-Identifier: Apache-2.0
"""scipy: computes."""

from _rosward import pure

pure(__name__)
