# SPDX-License-Identifier: Apache-2.0
"""`typing_extensions`: what `typing` has."""
from typing import *
from typing import _Form
ReadOnly = _Form()
def deprecated(message, /, *, category=None, stacklevel=1):
    def decorate(function):
        return function
    return decorate
