# SPDX-License-Identifier: Apache-2.0
"""ament_index_python.packages.

Read from ament_index_python 1.11.0 (kilted).
"""

from _rosward import pure, reads_only

import os
from pathlib import Path

from _rosward.launch import prefix_folder, share_folder


class PackageNotFoundError(KeyError): ...


@reads_only
def get_packages_with_prefixes() -> dict: ...


@pure
@reads_only
def _refuse(package_name) -> None: ...


def _look_up(package_name):
    if not os.path.isfile(f"{share_folder(package_name)}/package.xml"):  # of no package of the sources
        _refuse(package_name)


def get_package_prefix(package_name):
    _look_up(package_name)
    return prefix_folder(package_name)


def get_package_share_directory(package_name, print_warning=True):
    _look_up(package_name)
    return share_folder(package_name)


def get_package_share_path(package_name, print_warning=True):
    return Path(get_package_share_directory(package_name))
