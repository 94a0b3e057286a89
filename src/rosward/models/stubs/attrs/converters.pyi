# SPDX-License-Identifier: Apache-2.0
"""attrs.converters: that of `attr`.

Read from attrs 26.1.
"""
from attr.converters import *
