# SPDX-License-Identifier: Apache-2.0
"""The keywords under which a call passes what is not known of its arguments; no language has names like these.

lib.serve(Handler)      the library may make a Handler with whatever it likes: {ANY: UNBOUND}
f(*found)               as many positional arguments as there are in `found`: {LOOSE: any of them}
"""

from __future__ import annotations

from typing import Final

LOOSE: Final = "*"
"""Arguments of unknown number and name, joined."""
ORDER: Final = "*…"
"""Beside it, where they are positional: a tuple of what joins those of unknown number, and those behind them in order."""
ANY: Final = "?"
"""Whatever parameters are left get an unknown value (a call from code that is not known)."""
MAYBE: Final = "~"
"""The prefix of a keyword that may not be there: its value is joined with the parameter's default."""
