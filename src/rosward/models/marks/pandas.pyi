# SPDX-License-Identifier: Apache-2.0
"""pandas: tables from files."""

from _rosward import source

@source("file")
def read_csv(filepath_or_buffer, **kwargs): ...
@source("file")
def read_json(path_or_buf, **kwargs): ...
@source("file")
def read_excel(io, **kwargs): ...
