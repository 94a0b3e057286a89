# SPDX-License-Identifier: Apache-2.0
"""launch_ros.remap_rule_type: names for annotations.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from typing import Any

SomeRemapRule = Any
SomeRemapRules = Any
RemapRule = Any
RemapRules = Any
