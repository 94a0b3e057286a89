# SPDX-License-Identifier: Apache-2.0
"""nav2_simple_commander.

Read from ros-navigation/navigation2, branches humble (2026-06), iron (2024-10), jazzy (2026-08), kilted (2026-01), lyrical and main (2026-08).
"""

