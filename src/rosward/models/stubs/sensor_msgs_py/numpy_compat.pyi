# SPDX-License-Identifier: Apache-2.0
"""sensor_msgs_py.numpy_compat: computes.

Read from ros2/common_interfaces, branch rolling (2024-11).
"""

from _rosward import reads_only

reads_only(__name__)

def structured_to_unstructured(arr, dtype=None, copy=False, casting="unsafe"): ...
def unstructured_to_structured(arr, dtype=None, names=None, align=False, copy=False, casting="unsafe"): ...
