# SPDX-License-Identifier: Apache-2.0
"""`atexit`: what is registered runs at the end."""
from _rosward import reads_only, schedule

def register(func, /, *args, **kwargs):
    def run():
        func(*args, **kwargs)
    schedule(run, event='exit')
    return func
@reads_only
def unregister(func, /) -> None: ...
