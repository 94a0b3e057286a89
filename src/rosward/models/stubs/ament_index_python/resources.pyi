# SPDX-License-Identifier: Apache-2.0
"""ament_index_python.resources.

Read from ament_index_python 1.11.0 (kilted).
"""

from _rosward import reads_only

reads_only(__name__)

class InvalidResourceTypeNameError(ValueError): ...


class InvalidResourceNameError(ValueError): ...


def get_resource(resource_type, resource_name): ...
def get_resources(resource_type) -> dict: ...
def get_resource_types() -> set: ...
def has_resource(resource_type, resource_name): ...
