# SPDX-License-Identifier: Apache-2.0
"""nav2_common: what the launch files of Nav2 share.

Read from nav2_common 1.3.
"""

from _rosward import before_sources

before_sources(__name__)