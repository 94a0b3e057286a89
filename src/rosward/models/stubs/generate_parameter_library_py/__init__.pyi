# SPDX-License-Identifier: Apache-2.0
"""generate_parameter_library_py: makes Python modules of descriptions of parameters; rosward makes them itself (source/parameter_module.py)."""
