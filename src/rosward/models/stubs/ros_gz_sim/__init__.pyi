# SPDX-License-Identifier: Apache-2.0
"""ros_gz_sim."""
