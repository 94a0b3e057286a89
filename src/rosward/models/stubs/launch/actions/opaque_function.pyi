# SPDX-License-Identifier: Apache-2.0
"""launch.actions.opaque_function."""

from launch.actions import OpaqueFunction as OpaqueFunction
