# SPDX-License-Identifier: Apache-2.0
"""Lidar, camera and dock detection of the delivery robot."""
