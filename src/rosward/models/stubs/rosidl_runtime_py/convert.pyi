# SPDX-License-Identifier: Apache-2.0
"""rosidl_runtime_py.convert.

Read from ros2/rosidl_runtime_py, branch rolling (2024-04).
"""

from _rosward import reads_only

reads_only(__name__)

def message_to_yaml(msg, *, truncate_length=None, no_arr=False, no_str=False, flow_style=False) -> str: ...
def message_to_csv(msg, *, truncate_length=None, no_arr=False, no_str=False) -> str: ...
def message_to_ordereddict(msg, *, truncate_length=None, no_arr=False, no_str=False) -> dict: ...
def get_message_slot_types(msg) -> dict: ...
