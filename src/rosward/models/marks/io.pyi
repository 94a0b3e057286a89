# SPDX-License-Identifier: Apache-2.0
"""`io`: files are those of `open`."""

from builtins import open as open
