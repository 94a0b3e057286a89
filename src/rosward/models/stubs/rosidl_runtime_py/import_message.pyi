# SPDX-License-Identifier: Apache-2.0
"""rosidl_runtime_py.import_message.

Read from ros2/rosidl_runtime_py, branch rolling (2024-04).
"""

from _rosward import reads_only

reads_only(__name__)

def import_message_from_namespaced_type(message_type): ...
