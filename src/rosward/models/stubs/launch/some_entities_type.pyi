# SPDX-License-Identifier: Apache-2.0
"""launch.some_entities_type: a name for annotations.

Read from launch 3.7.0, with what humble had before it.
"""

from typing import Any

SomeEntitiesType = Any
SomeEntitiesType_types_tuple = ()
