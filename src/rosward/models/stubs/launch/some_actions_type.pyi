# SPDX-License-Identifier: Apache-2.0
"""launch.some_actions_type: a name for annotations.

Read from launch 3.7.0, with what humble had before it.
"""

from typing import Any

SomeActionsType = Any
SomeActionsType_types_tuple = ()
