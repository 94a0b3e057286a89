# SPDX-License-Identifier: Apache-2.0
"""PyYAML: its models in code."""

from _rosward import sink, source

@source("file")
def load(stream, Loader): ...
@source("file")
def safe_load(stream): ...
@sink("pickle")
def unsafe_load(stream): ...
