# SPDX-License-Identifier: Apache-2.0
"""launch_testing.asserts.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

reads_only(__name__)

def assertExitCodes(*args, **kwargs) -> None: ...
def assertInStdout(*args, **kwargs) -> None: ...
def assertInStderr(*args, **kwargs) -> None: ...
def assertSequentialStdout(*args, **kwargs): ...
EXIT_OK = 0
