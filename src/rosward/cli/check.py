# SPDX-License-Identifier: Apache-2.0
"""`rosward check`: does an existing policy let the system do what its code does, and nothing else?"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from rosward.cli.reviewing import add_output_file, add_review, deliver, findings_text, reviewed, write_baseline
from rosward.cli.shared import (
    WrongUseError,
    add_deployment,
    add_enclaves,
    add_format,
    add_sources,
    extracted,
    refusing,
    request_of,
)
from rosward.cli.status import COMPLETE, INCOMPLETE
from rosward.outputs.formats import OF_FINDINGS
from rosward.source import disk

if TYPE_CHECKING:
    from rosward.explanation.checked import Checked
    from rosward.policies.records import Policy
    from rosward.result import Result


def add(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.usage = "%(prog)s [options] POLICY.xml|permissions.xml… [PATH…]"
    parser.description = (
        "Report which permissions the policy is missing and which ones the code never uses. "
        "Arguments that end in .xml are policies (SROS2 policies or DDS permissions); the other paths are the sources."
    )
    parser.epilog = (
        "Exit status: 0 the policy matches the code exactly; 1 findings that are not in the baseline; 2 usage error or nothing to read; "
        "3 internal error."
    )
    parser.set_defaults(run=refusing(_run))
    add_sources(parser)
    add_deployment(parser)
    add_enclaves(parser)
    add_format(parser, "text", "json", *OF_FINDINGS)
    add_output_file(parser)
    add_review(parser)


def _run(options: argparse.Namespace) -> int:
    from rosward.policies.read import read_policy

    files = [p for p in options.paths if p.lower().endswith(".xml") and not disk.is_folder(p)]
    if not files:
        raise WrongUseError("no policy given: pass a file that ends in .xml")
    request = request_of(options)
    policy = read_policy(files)
    result = extracted(options, [p for p in options.paths if p not in files], request)
    found = _checked(policy, result, options)
    deliver(_text(found, options), options.output)
    return COMPLETE if found.clean else INCOMPLETE


def _checked(policy: Policy, result: Result, options: argparse.Namespace) -> Checked:
    """Findings in the sources and in the policy are reviewed apart: their places are relative to different folders."""
    from rosward.explanation.checked import checked
    from rosward.policies.compare import compare
    from rosward.suppression.judge import SourceTexts

    differences = compare(result.network, policy) if policy.enclaves else ()
    sources, papers = SourceTexts(result.root, result.files), SourceTexts(Path.cwd(), ())
    in_code = dict.fromkeys((*result.findings, *(d.finding for d in differences if not d.in_policy)))
    in_policy = dict.fromkeys((*policy.findings, *(d.finding for d in differences if d.in_policy)))
    code = reviewed(list(in_code), sources, options, unused=False)
    paper = reviewed(list(in_policy), papers, options, unused=False)
    if options.write_baseline is not None:
        write_baseline((*code.shown, *paper.shown), options.write_baseline)
    return checked(policy, differences, code, paper, (sources.prefix, papers.prefix))


def _text(found: Checked, options: argparse.Namespace) -> str:
    from rosward.outputs.documents.check_json import check_json
    from rosward.outputs.terminal.check_text import check_text

    if options.format in OF_FINDINGS:
        return findings_text(options.format, found.shown, options)
    return check_json(found) if options.format == "json" else check_text(found)
