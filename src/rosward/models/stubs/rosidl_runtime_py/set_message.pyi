# SPDX-License-Identifier: Apache-2.0
"""rosidl_runtime_py.set_message.

Read from ros2/rosidl_runtime_py, branch rolling (2024-04).
"""

from _rosward import changes

@changes("msg")
def set_message_fields(msg, values, expand_header_auto=False, expand_time_now=False) -> list: ...
