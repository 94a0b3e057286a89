# SPDX-License-Identifier: Apache-2.0
"""launch.descriptions.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward.launch import REQUIRED, keep


class Executable:
    def __init__(self, *, cmd=REQUIRED, prefix=None, name=None, cwd=None, env=None, additional_env=None, arguments=None):
        self.cmd = cmd
        keep(self, None, cmd=cmd, prefix=prefix, env=env, additional_env=additional_env, arguments=arguments)
