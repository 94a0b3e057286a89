# SPDX-License-Identifier: Apache-2.0
"""`shutil`: files are written."""

from _rosward import sink

sink("file", __name__)
