# SPDX-License-Identifier: Apache-2.0
"""launch_ros.actions.lifecycle_transition."""

from launch_ros.actions import LifecycleTransition as LifecycleTransition
