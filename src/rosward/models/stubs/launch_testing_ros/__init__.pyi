# SPDX-License-Identifier: Apache-2.0
"""launch_testing_ros: tests around a launch.

Read from launch 3.7.0, with what humble had before it.
"""

class WaitForTopics:
    def __init__(self, topic_tuples, timeout=5.0, **kwargs): ...
    def wait(self) -> bool: ...
    def shutdown(self) -> None: ...
