# SPDX-License-Identifier: Apache-2.0
"""launch_testing.tools.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

reads_only(__name__)

def basic_output_filter(*args, **kwargs): ...
def expect_output(*args, **kwargs) -> None: ...
