# SPDX-License-Identifier: Apache-2.0
"""The findings as test reports show them: JUnit XML.

    <testcase classname="src/talker.py" name="RW102 partly known name"><failure type="warning" …>src/talker.py:20: …</failure></testcase>

One test case for each rule that speaks of a file. Errors and warnings are failures, notes are output; a case all of whose findings are in the
baseline is skipped. Without any finding there is one case, which passes, for servers take a report without cases as broken.
"""

from __future__ import annotations

from collections.abc import Sequence

from rosward.outputs.writing import Scan
from rosward.rules import RULES, Severity
from rosward.safe import printable, xml_attribute, xml_text
from rosward.suppression.judge import Judged

__all__ = ["junit_xml", "text"]


def text(scan: Scan) -> str:
    """The document of the format `junit`."""
    return junit_xml(scan.findings)


def junit_xml(findings: Sequence[Judged]) -> str:
    """The text of `findings.junit.xml`."""
    groups: dict[tuple[str, str], list[Judged]] = {}
    for judged in findings:
        groups.setdefault((judged.file, judged.finding.code), []).append(judged)
    cases = [_case(file, code, group) for (file, code), group in sorted(groups.items(), key=lambda item: item[0])]
    cases = cases or ['    <testcase classname="rosward" name="no findings"/>\n']
    numbers = " ".join(
        f'{name}="{number}"'
        for name, number in (
            ("tests", len(cases)),
            ("failures", sum("<failure " in case for case in cases)),
            ("errors", 0),
            ("skipped", sum("<skipped " in case for case in cases)),
        )
    )
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        f'<testsuites name="rosward" {numbers}>\n'
        f'  <testsuite name="rosward" {numbers}>\n{"".join(cases)}  </testsuite>\n'
        "</testsuites>\n"
    )


def _case(file: str, code: str, group: Sequence[Judged]) -> str:
    rule = RULES[code]
    shown = [j for j in group if not j.known]
    head = f'    <testcase classname="{_attribute(file or "rosward")}" name="{_attribute(f"{code} {rule.title}")}">\n'
    lines = xml_text("\n".join(_line(j) for j in shown or group))
    if not shown:
        body = '      <skipped message="in the baseline"/>\n'
    elif rule.severity is Severity.NOTE:
        body = f"      <system-out>{lines}</system-out>\n"
    else:
        message = _attribute(f"{rule.title}: {len(shown)}. {rule.help}")
        body = f'      <failure type="{rule.severity.value}" message="{message}">{lines}</failure>\n'
    return f"{head}{body}    </testcase>\n"


def _line(judged: Judged) -> str:
    line = judged.finding.place.line
    place = f"{judged.file}:{line}" if line else judged.file
    return printable(f"{place}: {judged.finding.message}" if place else judged.finding.message)


def _attribute(text: str) -> str:
    return xml_attribute(printable(text))
