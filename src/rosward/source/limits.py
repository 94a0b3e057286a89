# SPDX-License-Identifier: Apache-2.0
"""How large may a file be that is read, and how deep?

What is read comes from somebody, so every reader has a bound, and refuses beyond it: nothing is read in part. The bounds are wide for what
people write, and narrow for what takes long. Sizes are in bytes where a file is opened, in characters where a text is already there. What
only one algorithm counts (steps, alternatives, findings that are told) stands beside it.
"""

from __future__ import annotations

from typing import Final

# Of the sources

PYTHON_FILE: Final = 4_000_000
"""More is generated data, not a program."""
STUB_FILE: Final = 1_000_000
MANIFEST_FILE: Final = 1_000_000
"""package.xml."""
MANIFEST_DEPTH: Final = 50
MANIFEST_ELEMENTS: Final = 2_000
"""catkin_pkg compares each dependency with each."""
MANIFEST_CONDITION: Final = 200
"""Characters; catkin_pkg's parser is exponential in nested parentheses."""
DESCRIPTION_FILE: Final = 1_000_000
"""setup.py, setup.cfg, pyproject.toml."""
CMAKE_FILE: Final = 1_000_000
CMAKE_DEPTH: Final = 20
"""Of included files and called functions."""
CMAKE_FUNCTIONS_FILE: Final = 300_000
"""Files of other packages in which a function is looked for."""
COMPILE_COMMANDS_FILE: Final = 20_000_000
CPP_FILE: Final = 2_000_000
"""Also what the preprocessor hands to the parser."""
PARAMETERS_FILE: Final = 300_000
"""YAML of which generate_parameter_library makes a module."""
INTERFACE_FILE: Final = 1_000_000
"""Of .msg, .srv and .action."""
DATA_FILE: Final = 1_000_000
"""What is read as plain data."""
SEARCHED_FILE: Final = 16_000_000
"""In which the beginning of a declaration is looked for; also what `ros2 node info` printed."""
EXCERPT_FILE: Final = 2_000_000
"""Of which lines are shown."""

# Of the deployment

LAUNCH_XML_TEXT: Final = 2_000_000
LAUNCH_YAML_TEXT: Final = 500_000
LAUNCH_ELEMENTS: Final = 50_000
LAUNCH_DEPTH: Final = 60
DECLARED_FILE: Final = 2_000_000
"""Declared nodes, and the configurations that they read."""
MODELS_FILE: Final = 2_000_000
"""Of declared nodes and stubs, for the fingerprint of the models."""
YAML_TEXT: Final = 100_000
"""Of a value that launch reads as YAML; a longer one is taken for a str (a robot description)."""
YAML_DEPTH: Final = 100
YAML_TEXT_DEPTH: Final = 50
PARAMETER_KEYS: Final = 50_000
PARAMETER_NESTING: Final = 200
"""Of lists: libyaml's time is the square of it."""
PARAMETER_NAME: Final = 4_000
"""Characters of a name made of nested keys."""

# Of the user

CONFIGURATION_FILE: Final = 1_000_000
"""rosward.toml, and pyproject.toml for it."""
TOML_KEY_PARTS: Final = 30_000_000
"""Parts of keys that are looked at: about a second."""
ASSIGNMENT_FILE: Final = 10_000_000
"""Which enclave has which node."""
BASELINE_FILE: Final = 32_000_000
ACCEPTED_FILE: Final = 1_000_000
COMMENT_YAML_TEXT: Final = 1_000_000
"""YAML in which comments are looked for."""
POLICY_FILE: Final = 4_000_000
POLICY_INCLUDED_FILE: Final = 1_000_000
POLICY_DEPTH: Final = 30
POLICY_ELEMENTS: Final = 20_000
POLICY_INCLUDES: Final = 200
POLICY_INCLUDE_DEPTH: Final = 8

# Of what rosward, or a robot, has written

JSON_FILE: Final = 64_000_000
"""network.json, snapshots."""
JSON_NAME: Final = 1_000
"""Characters of a text in it that is a name."""
COMPLETED_FILE: Final = 50_000_000
"""network.json, where the Tab key offers its names."""
REPLACED_FILE: Final = 100_000_000
"""A policy.xml of which the beginning says whether it is ours."""
DIFF_FILE: Final = 32_000_000
NODE_INFO_TEXT: Final = 16_000_000
RESULT_FILE: Final = 16_000_000
"""What the server keeps of a result, and shows of a file of it."""
