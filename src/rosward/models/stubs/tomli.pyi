# SPDX-License-Identifier: Apache-2.0
"""`tomli`: text that stands in the program, or in a file of the sources, is read (models/python/std/data.py)."""
from tomllib import TOMLDecodeError as TOMLDecodeError, load as load, loads as loads
