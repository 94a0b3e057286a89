# SPDX-License-Identifier: Apache-2.0
"""launch.actions.emit_event."""

from launch.actions import EmitEvent as EmitEvent
