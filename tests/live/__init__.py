# SPDX-License-Identifier: Apache-2.0
"""The static answer held against the real rclpy: programs run, their graph is read, and both must agree."""
