# SPDX-License-Identifier: Apache-2.0
"""rclpy.impl.implementation_singleton: the compiled part, whose functions are unknown.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import raises_nothing

raises_nothing(__name__)

class _Implementation: ...


rclpy_implementation = _Implementation()
