# SPDX-License-Identifier: Apache-2.0
"""ament_index_python.search_paths.

Read from ament_index_python 1.11.0 (kilted).
"""

from _rosward import reads_only

reads_only(__name__)

def get_search_paths() -> list: ...
