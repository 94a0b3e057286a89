# SPDX-License-Identifier: Apache-2.0
"""What do the macros do that write a line to a log, and those that check something? Nothing that is found depends on it.

RCLCPP_INFO(get_logger(), "%s", name.c_str());  RCUTILS_LOG_WARN(…);  assert(node != nullptr);
"""

from __future__ import annotations

from typing import Final

from rosward.domain.values import NONE, Value
from rosward.models.native import NativeCall, NativeFunction

__all__ = ["NATIVES"]

_LEVELS: Final = ("DEBUG", "INFO", "WARN", "ERROR", "FATAL")
_FORMS: Final = ("", "_STREAM")
_WHEN: Final = (
    "", "_ONCE", "_THROTTLE", "_SKIPFIRST", "_SKIPFIRST_THROTTLE", "_EXPRESSION", "_FUNCTION",
)  # fmt: skip
_CHECKS: Final = ("assert", "static_assert", "rcpputils.assert_true", "rcpputils.require_true", "rcpputils.check_true")
_PRINTS: Final = ("std.printf", "std.fprintf", "std.puts", "std.fputs", "std.putchar", "std.fflush", "fmt.print")
_SET: Final = (
    "rcutils_logging_set_logger_level",
    "rcutils_logging_initialize",
    "std.setvbuf",
    "std.ios_base.sync_with_stdio",
)


def _nothing(call: NativeCall) -> Value:
    del call
    return NONE


def _names() -> list[str]:
    rclcpp = [f"RCLCPP_{level}{form}{when}" for level in _LEVELS for form in _FORMS for when in _WHEN]
    rcutils = [f"RCUTILS_LOG_{level}{when}{named}" for level in _LEVELS for when in _WHEN for named in ("", "_NAMED")]
    return [*rclcpp, *rcutils, *_CHECKS, *_PRINTS, *_SET]


NATIVES: Final[dict[str, NativeFunction]] = dict.fromkeys(_names(), _nothing)
