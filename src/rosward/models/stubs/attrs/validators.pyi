# SPDX-License-Identifier: Apache-2.0
"""attrs.validators: that of `attr`.

Read from attrs 26.1.
"""
from attr.validators import *
