# SPDX-License-Identifier: Apache-2.0
"""`python -m rosward`."""

import sys

from rosward.cli import main

sys.exit(main())
