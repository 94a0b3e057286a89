# SPDX-License-Identifier: Apache-2.0
"""What runs on the robot, and does the source explain it?"""
