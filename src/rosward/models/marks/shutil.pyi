# SPDX-License-Identifier: Apache-2.0
"""`shutil`: files are written."""

from _rosward import changes, sink

sink("file", __name__)

@changes("fdst")
@sink("file")
def copyfileobj(fsrc, fdst, length=0): ...
