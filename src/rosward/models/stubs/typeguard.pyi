# SPDX-License-Identifier: Apache-2.0
"""`typeguard`: checks the types of what a function is given, and leaves it as it is.

Read from typeguard 4.6.
"""
from _rosward import reads_only

def typechecked(target=None, **options):
    def decorate(target):
        return target
    return decorate if target is None else target
def typeguard_ignore(f):
    return f
def check_type(value, expected_type, **options):
    return value
@reads_only
def install_import_hook(packages=None, ignore_packages=(), *, cls=None): ...

class _Suppressed:
    def __enter__(self):
        return None
    def __exit__(self, exc_type, exc_val, exc_tb):
        return None

def suppress_type_checks(func=None):
    return _Suppressed() if func is None else func
