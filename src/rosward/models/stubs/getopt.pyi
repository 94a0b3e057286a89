# SPDX-License-Identifier: Apache-2.0
"""`getopt`: any number of the options named (models/python/std/arguments.py)."""

class GetoptError(Exception):
    opt = ''
    msg = ''
error = GetoptError

