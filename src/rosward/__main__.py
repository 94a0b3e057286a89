# SPDX-License-Identifier: Apache-2.0
"""`python -m rosward`."""
# PYTHON_ARGCOMPLETE_OK

from rosward.cli import program

program()
