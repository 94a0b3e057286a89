# SPDX-License-Identifier: Apache-2.0
"""`curses`: the wrapper calls a function with the screen; what else there is draws on it, or says what a person did."""
from _curses import window

def wrapper(func, /, *args, **kwds):
    return func(window(), *args, **kwds)
