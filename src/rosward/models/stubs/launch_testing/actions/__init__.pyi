# SPDX-License-Identifier: Apache-2.0
"""launch_testing.actions.

Read from launch 3.7.0, with what humble had before it.
"""

from launch.action import Action


class _Test(Action):
    def __init__(self, *args, **kwargs):
        super().__init__()


class ReadyToTest(_Test): ...
class GTest(_Test): ...
class PyTest(_Test): ...
class Test(_Test): ...
