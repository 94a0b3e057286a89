# SPDX-License-Identifier: Apache-2.0
"""`termios`: the terminal, as it is."""
from _rosward import reads_only, unknown

reads_only(__name__)

TCSADRAIN = 1
TCSANOW = 0
TCSAFLUSH = 2
ECHO = 8
ICANON = 2
TCIFLUSH = 0
VMIN = 6
VTIME = 5

class error(Exception): ...
def tcgetattr(fd, /):
    return unknown('live', 'state of the terminal', 'list')
def tcsetattr(fd, when, attributes, /) -> None: ...
def tcflush(fd, queue, /) -> None: ...
