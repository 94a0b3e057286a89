# SPDX-License-Identifier: Apache-2.0
"""launch.actions.execute_process."""

from launch.actions import ExecuteProcess as ExecuteProcess
from launch.actions.execute_local import ExecuteLocal as ExecuteLocal
from launch.actions.shutdown_action import Shutdown as Shutdown
from launch.descriptions import Executable as Executable
from launch.some_substitutions_type import SomeSubstitutionsType as SomeSubstitutionsType
from launch.substitution import Substitution as Substitution
from launch.substitutions import TextSubstitution as TextSubstitution
