# SPDX-License-Identifier: Apache-2.0
"""launch.frontend.entity."""

from launch.frontend import Entity as Entity
