# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.for_var."""

from launch.substitutions import ForEachVar as ForEachVar
from launch.substitutions import ForLoopIndex as ForLoopIndex
