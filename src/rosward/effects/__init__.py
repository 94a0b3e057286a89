# SPDX-License-Identifier: Apache-2.0
"""How is a process started, and what does it do to ROS? The records that the interpretation keeps."""
