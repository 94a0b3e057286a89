# SPDX-License-Identifier: Apache-2.0
"""quaternion: rotations."""

from _rosward import pure

pure(__name__)
