# SPDX-License-Identifier: Apache-2.0
"""launch.logging: it logs.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

import logging
from logging import getLogger

reads_only(__name__)


class LaunchConfig:
    level = logging.INFO
    log_dir = ""
    log_handler_factory = None
    def reset(self) -> None: ...
    def set_screen_format(self, screen_format, *, screen_style=None) -> None: ...
    def set_log_format(self, log_format, *, log_style=None) -> None: ...
    def get_log_file_path(self, file_name="launch.log") -> str: ...


launch_config = LaunchConfig()


def get_logger(name=None): return getLogger(name)
def get_output_loggers(process_name, output_config): return (getLogger(), getLogger())
def reset() -> None: ...
