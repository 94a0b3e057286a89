# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.anon_name."""

from launch.substitutions import AnonName as AnonName
