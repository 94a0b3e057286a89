# SPDX-License-Identifier: Apache-2.0
"""rclpy.type_support.

Read from rclpy 9.1.2 (kilted) and the branches humble (3.3.15), iron (4.1.7), jazzy (7.1.3) and rolling (8.0.0, December 2024).
"""

from _rosward import reads_only

reads_only(__name__)

class NoTypeSupportImportedException(Exception): ...


class Msg: ...


class Srv: ...


class Action: ...


def check_for_type_support(msg_or_srv_type) -> None: ...
def check_is_valid_msg_type(msg_type) -> None: ...
def check_is_valid_srv_type(srv_type) -> None: ...
