# SPDX-License-Identifier: Apache-2.0
"""rosidl_runtime_py.import_message.

Read from ros2/rosidl_runtime_py, branch rolling (2024-04).
"""

def import_message_from_namespaced_type(message_type): ...
