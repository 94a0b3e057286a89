# SPDX-License-Identifier: Apache-2.0
"""rclpy.parameter_service: made by every node (rows of the table of implicit entities).

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

class ParameterService:
    def __init__(self, node) -> None: ...
