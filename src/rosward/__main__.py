# SPDX-License-Identifier: Apache-2.0
"""`python -m rosward`."""
# PYTHON_ARGCOMPLETE_OK

import sys

from rosward.cli import main

sys.exit(main())
