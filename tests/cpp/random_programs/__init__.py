# SPDX-License-Identifier: Apache-2.0
"""Which program could there be? One random program, written in Python (rclpy) and in C++ (rclcpp).

    write(7)    ->  Written(python="import rclpy …", cpp="#include …", used={"virtual", "snprintf"}, open=False)

Both say the same, statement by statement, so they must have the same graph: `programs` puts a program together of values (`texts`, `said`,
`numbers`, `parameters`), of what a body does (`statements`, `data`, `flow`), and of functions and classes that it uses (`shapes`).
"""

from .programs import Written, write

__all__ = ["Written", "write"]
