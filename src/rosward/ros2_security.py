# SPDX-License-Identifier: Apache-2.0
"""How does `ros2 security` come to the verb extract_policy?

    pyproject.toml, entry point of the group sros2.verb  ->  ExtractPolicyVerb  ->  cli/extract_policy.py

Nobody but ros2cli imports this module, so rosward needs nothing of ROS.
"""

from __future__ import annotations

import argparse
from typing import final

from sros2.verb import VerbExtension

from rosward.cli import extract_policy

__all__ = ["ExtractPolicyVerb"]


@final
class ExtractPolicyVerb(VerbExtension):  # type: ignore[misc]  # sros2 has no types
    """Generate XML policy file from source code."""

    def add_arguments(self, parser: argparse.ArgumentParser, cli_name: str) -> None:  # noqa: ARG002
        """Declare the options of the verb."""
        extract_policy.add_arguments(parser)

    def main(self, *, args: argparse.Namespace) -> int:
        """Run the verb; returns the exit status."""
        return extract_policy.run(args)
