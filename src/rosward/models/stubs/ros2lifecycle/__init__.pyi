# SPDX-License-Identifier: Apache-2.0
"""ros2lifecycle: see api.pyi."""
