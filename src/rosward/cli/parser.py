# SPDX-License-Identifier: Apache-2.0
"""How are the words of a command line taken, and what is said of wrong ones?

argparse takes all that may be missing at the first place where it may stand, so that a PATH behind an option is none to it,
and it prints every option before it says what is wrong:

rosward explain /scan --launch robot.launch.py src        taken: src is a PATH
rosward extract --unkown=deny                             rosward extract: error: unrecognized arguments: --unkown=deny; did you mean --unknown?
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any, NoReturn, final

__all__ = ["CommandParser"]


@final
class CommandParser(argparse.ArgumentParser):
    """A parser whose PATHs may stand anywhere, and which says shortly what is wrong."""

    def parse_known_args(self, args: Sequence[str] | None = None, namespace: Any = None) -> tuple[Any, list[str]]:  # type: ignore[override]  # the stubs have overloads for the namespace
        """The options; nothing is left over."""
        options, rest = super().parse_known_args(args, namespace)
        if rest and (not self._takes_paths() or any(word.startswith("-") and word != "--" for word in rest)):
            self.error(f"unrecognized arguments: {' '.join(rest)}{self._meant(rest)}")
        if rest:
            options.paths = [*options.paths, *(word for word in rest if word != "--")]
        return options, []

    def error(self, message: str) -> NoReturn:
        """Say what is wrong and where the options are told; status 2."""
        from rosward.safe import printable

        self.exit(2, f"{self.prog}: error: {printable(message)}\nSee `{self.prog} --help` for usage.\n")

    def _takes_paths(self) -> bool:
        return any(action.dest == "paths" and action.nargs == "*" for action in self._actions)

    def _meant(self, words: Sequence[str]) -> str:
        import difflib

        known = [name for action in self._actions for name in action.option_strings if name.startswith("--")]
        unknown = [word.partition("=")[0] for word in words if word.startswith("--")]
        close = [name for word in unknown for name in difflib.get_close_matches(word, known, n=1)]
        return f"; did you mean {' '.join(close)}?" if close else ""
