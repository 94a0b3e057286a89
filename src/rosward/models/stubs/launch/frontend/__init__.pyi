# SPDX-License-Identifier: Apache-2.0
"""launch.frontend: classes that XML and YAML launch files may name.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import reads_only

reads_only(__name__)

class Entity: ...


class Parser:
    @classmethod
    def load(cls, file): ...
    def parse_description(self, entity): ...
    def parse_substitution(self, value): ...


class InvalidFrontendLaunchFileError(Exception): ...


def expose_action(name): return lambda exposed: exposed
def expose_substitution(name): return lambda exposed: exposed
