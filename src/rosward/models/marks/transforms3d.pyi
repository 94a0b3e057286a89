# SPDX-License-Identifier: Apache-2.0
"""transforms3d: rotations."""

from _rosward import pure

pure(__name__)
