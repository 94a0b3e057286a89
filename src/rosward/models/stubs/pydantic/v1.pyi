# SPDX-License-Identifier: Apache-2.0
"""pydantic.v1: the names of pydantic 1.

Read from pydantic 1.10.
"""
from pydantic import *
