# SPDX-License-Identifier: Apache-2.0
"""launch.launch_introspector.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

reads_only(__name__)

class LaunchIntrospector:
    def format_launch_description(self, launch_description) -> str: ...
