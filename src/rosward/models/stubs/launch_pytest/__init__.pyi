# SPDX-License-Identifier: Apache-2.0
"""launch_pytest: tests around a launch.

Read from launch 3.7.0, with what humble had before it.
"""

def fixture(*args, **kwargs): return args[0] if args else (lambda function: function)
