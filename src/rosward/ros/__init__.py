# SPDX-License-Identifier: Apache-2.0
"""ROS 2's own rules, pure functions: entities, names, arguments, what each distro's client library adds."""
