# SPDX-License-Identifier: Apache-2.0
"""launch_param_builder.launch_param_builder."""

from launch_param_builder import ParameterBuilder as ParameterBuilder
