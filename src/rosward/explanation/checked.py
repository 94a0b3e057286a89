# SPDX-License-Identifier: Apache-2.0
"""What `rosward check` found, after comments, configuration and baseline had their say; the outputs write it down.

Checked(policy, differences=(Difference("/talker", "publisher /status", Judged(RW401 …)), …), unread=(), questions=())
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from rosward.findings import Finding
from rosward.policies.compare import Discrepancy, Related
from rosward.policies.records import Policy
from rosward.records import NamedTuple
from rosward.rules import Severity
from rosward.suppression.judge import Judged, RelatedPlace, Reviewed

__all__ = ["Checked", "ShownDiscrepancy", "checked"]


class ShownDiscrepancy(NamedTuple):
    """A discrepancy that is shown."""

    enclave: str
    right: str
    judged: Judged


class Checked(NamedTuple):
    """All that is told. `unread` are parts of the policy, `questions` what is not known of the code; `ignored` is a number."""

    policy: Policy
    differences: tuple[ShownDiscrepancy, ...] = ()
    unread: tuple[Judged, ...] = ()
    questions: tuple[Judged, ...] = ()
    ignored: int = 0

    @property
    def shown(self) -> tuple[Judged, ...]:
        """Every finding, each once."""
        return tuple(dict.fromkeys((*self.unread, *(d.judged for d in self.differences), *self.questions)))

    @property
    def known(self) -> int:
        """How many are in the baseline."""
        return sum(j.known for j in self.shown)

    @property
    def clean(self) -> bool:
        """Whether nothing new is left."""
        return all(j.known for j in self.shown)


def checked(
    policy: Policy, discrepancies: Sequence[Discrepancy], code: Reviewed, paper: Reviewed, prefixes: tuple[str, str]
) -> Checked:
    """Put together what was found: `code` are the findings whose place is in the sources, `paper` those in the policy.

    `prefixes` are the folders of the places of both below the root of the repository.
    """
    judged = {(j.finding, False): j for j in code.shown} | {(j.finding, True): j for j in paper.shown}
    of_policy = {d.finding for d in discrepancies}
    differences = []
    for one in discrepancies:
        found = judged.get((one.finding, one.in_policy))
        if found is not None:
            related = tuple(_related(one.related, prefixes))
            differences.append(ShownDiscrepancy(one.enclave, one.right, found._replace(related=related)))
    return Checked(
        policy,
        tuple(differences),
        tuple(j for j in paper.shown if j.finding in policy.findings),
        tuple(j for j in code.shown if j.finding not in of_policy and _is_error(j.finding)),
        code.ignored + paper.ignored,
    )


def _is_error(finding: Finding) -> bool:
    return finding.rule.severity is Severity.ERROR


def _related(related: Iterable[Related], prefixes: tuple[str, str]) -> Iterator[RelatedPlace]:
    for message, place, in_policy in related:
        if place.file:
            file = place.file if place.file.startswith("/") else prefixes[in_policy] + place.file
            yield RelatedPlace(message, file, place.line, place.column)
