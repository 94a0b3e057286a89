# SPDX-License-Identifier: Apache-2.0
"""curses, for those who make the screen themselves."""

from _curses import initscr, newwin, window
