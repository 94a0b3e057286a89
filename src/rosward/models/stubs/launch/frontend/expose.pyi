# SPDX-License-Identifier: Apache-2.0
"""launch.frontend.expose."""

from launch.frontend import expose_action as expose_action
from launch.frontend import expose_substitution as expose_substitution
