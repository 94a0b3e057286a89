# SPDX-License-Identifier: Apache-2.0
"""launch.substitutions.python_expression."""

from launch.substitutions import PythonExpression as PythonExpression
