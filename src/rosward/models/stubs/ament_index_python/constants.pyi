# SPDX-License-Identifier: Apache-2.0
"""ament_index_python.constants.

Read from ament_index_python 1.11.0 (kilted).
"""

RESOURCE_INDEX_SUBFOLDER = "share/ament_index/resource_index"
AMENT_PREFIX_PATH_ENV_VAR = "AMENT_PREFIX_PATH"
