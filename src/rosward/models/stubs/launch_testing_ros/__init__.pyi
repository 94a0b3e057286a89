# SPDX-License-Identifier: Apache-2.0
"""launch_testing_ros: tests around a launch.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

reads_only(__name__)

class WaitForTopics:
    def __init__(self, topic_tuples, timeout=5.0, **kwargs): ...
    def wait(self) -> bool: ...
    def shutdown(self) -> None: ...
