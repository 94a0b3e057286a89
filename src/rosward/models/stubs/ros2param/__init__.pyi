# SPDX-License-Identifier: Apache-2.0
"""ros2param: see api.pyi."""
