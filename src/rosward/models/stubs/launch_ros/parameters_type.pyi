# SPDX-License-Identifier: Apache-2.0
"""launch_ros.parameters_type: names for annotations.

Read from launch_ros 0.28.0, with what humble had before it.
"""

from typing import Any

SomeParameters = Any
SomeParametersDict = Any
SomeParameterFile = Any
SomeParameterName = Any
SomeParameterValue = Any
Parameters = Any
ParametersDict = Any
ParameterValue = Any
EvaluatedParameters = Any
EvaluatedParameterValue = Any
