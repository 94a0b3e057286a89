# SPDX-License-Identifier: Apache-2.0
"""rclpy.type_hash (iron and later).

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

class TypeHash:
    def __init__(self, version=-1, value=b""):
        self.version = version
        self.value = value
