# SPDX-License-Identifier: Apache-2.0
"""launch_testing: tests around a launch; they start nothing.

Read from launch 3.7.0, with what humble had before it.
"""

from launch_testing import actions as actions
from launch_testing import asserts as asserts
from launch_testing import markers as markers
from launch_testing import tools as tools
from launch_testing import util as util


def post_shutdown_test(): return lambda tested: tested
class LaunchTestService: ...
def parametrize(argnames, argvalues): return lambda function: function
