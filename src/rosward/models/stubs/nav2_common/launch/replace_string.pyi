# SPDX-License-Identifier: Apache-2.0
"""nav2_common.launch.replace_string."""

from nav2_common.launch import ReplaceString as ReplaceString
