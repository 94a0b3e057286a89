# SPDX-License-Identifier: Apache-2.0
"""`rosward completion SHELL`: the lines by which a shell asks rosward what can stand next. What the answer is, `completion.py` says."""

from __future__ import annotations

import argparse
import sys
from typing import Final

from rosward.cli.shared import WrongUseError
from rosward.cli.status import COMPLETE

_SHELLS: Final = ("bash", "zsh", "fish")
_WHERE: Final = """\
where to put it:
  bash  rosward completion bash > ~/.local/share/bash-completion/completions/rosward
  zsh   rosward completion zsh > DIR/_rosward, where DIR is a folder of $fpath
  fish  rosward completion fish > ~/.config/fish/completions/rosward.fish

Or, for this shell alone: eval "$(rosward completion bash)", rosward completion fish | source.
Completion needs an additional package: pip install 'rosward[completion]'."""


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.description = "Print a script that makes a shell complete commands, options, launch files and names."
    parser.epilog = _WHERE
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.set_defaults(run=_run)
    parser.add_argument("shell", choices=_SHELLS, metavar="SHELL", help=", ".join(_SHELLS))


def _run(options: argparse.Namespace) -> int:
    try:
        from argcomplete.shell_integration import shellcode
    except ImportError as error:
        raise WrongUseError("completion needs an additional package: pip install 'rosward[completion]'") from error
    sys.stdout.write(shellcode(["rosward"], shell=options.shell).rstrip() + "\n")
    return COMPLETE
