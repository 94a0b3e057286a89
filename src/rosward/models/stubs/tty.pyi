# SPDX-License-Identifier: Apache-2.0
"""`tty`: the terminal, as it is."""

from _rosward import reads_only

reads_only(__name__)

def setraw(fd, when=2): ...
def setcbreak(fd, when=2): ...
