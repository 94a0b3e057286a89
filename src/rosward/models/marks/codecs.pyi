# SPDX-License-Identifier: Apache-2.0
"""`codecs`: files with an encoding."""

from builtins import open as open
