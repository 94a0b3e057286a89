# SPDX-License-Identifier: Apache-2.0
"""launch_pytest.actions."""

from launch_testing.actions import ReadyToTest as ReadyToTest
