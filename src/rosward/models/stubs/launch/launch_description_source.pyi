# SPDX-License-Identifier: Apache-2.0
"""launch.launch_description_source: where an included description comes from.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

from _rosward.launch import keep

reads_only(__name__)


class LaunchDescriptionSource:
    def __init__(self, launch_description=None, location="<string>", method="unspecified mechanism from a script"):
        self.location = location
        keep(self, None, description=launch_description, location=location)

    def try_get_launch_description_without_context(self): ...
    def get_launch_description(self, context): ...
    @property
    def method(self) -> str: ...
