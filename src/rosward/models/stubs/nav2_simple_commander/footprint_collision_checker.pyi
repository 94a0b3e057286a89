# SPDX-License-Identifier: Apache-2.0
"""nav2_simple_commander.footprint_collision_checker: computes.

Read from ros-navigation/navigation2, branches humble (2026-06), iron (2024-10), jazzy (2026-08), kilted (2026-01), lyrical and main (2026-08).
"""
from _rosward import reads_only

reads_only(__name__)

NO_INFORMATION = 255
LETHAL_OBSTACLE = 254
INSCRIBED_INFLATED_OBSTACLE = 253
MAX_NON_OBSTACLE = 252
FREE_SPACE = 0


class FootprintCollisionChecker:
    def __init__(self) -> None: ...
    def footprintCost(self, footprint): ...
    def lineCost(self, x0, x1, y0, y1, step_size=0.5): ...
    def worldToMapValidated(self, wx, wy): ...
    def pointCost(self, x, y): ...
    def setCostmap(self, costmap): ...
    def footprintCostAtPose(self, x, y, theta, footprint): ...
