# SPDX-License-Identifier: Apache-2.0
"""diagnostic_updater: a publisher of /diagnostics, two parameters and a timer.

Read from ros/diagnostics, branches ros2 and ros2-jazzy (2024-03).
"""

from diagnostic_updater._diagnostic_status_wrapper import *
from diagnostic_updater._diagnostic_updater import *
from diagnostic_updater._publisher import *
from diagnostic_updater._update_functions import *
