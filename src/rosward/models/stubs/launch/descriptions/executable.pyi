# SPDX-License-Identifier: Apache-2.0
"""launch.descriptions.executable."""

from launch.descriptions import Executable as Executable
