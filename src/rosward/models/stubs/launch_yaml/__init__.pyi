# SPDX-License-Identifier: Apache-2.0
"""launch_yaml: launch files in YAML.

Read from launch 3.7.0, with what humble had before it.
"""

from _rosward import before_sources

from launch_yaml import launch_description_sources as launch_description_sources

before_sources(__name__)
