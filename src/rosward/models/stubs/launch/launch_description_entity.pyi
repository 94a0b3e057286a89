# SPDX-License-Identifier: Apache-2.0
"""launch.launch_description_entity: what a launch description consists of.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

class LaunchDescriptionEntity:
    @reads_only
    def describe(self) -> str: ...
    def describe_sub_entities(self): return []
    def describe_conditional_sub_entities(self): return []
    def visit(self, context): return [self]
    def get_asyncio_future(self): return None
