# SPDX-License-Identifier: Apache-2.0
"""What does a policy say, whatever the notation that it is written in?

<topics publish="ALLOW"><topic>chatter</topic></topics>  in the profile /robot talker
  ->  PolicyRule(allow=True, words="topics publish", name="/robot/chatter", rights=(publish rt/robot/chatter,))
"""

from __future__ import annotations

from typing import NamedTuple

from rosward.findings import Finding
from rosward.location import Place
from rosward.policies.rights import Right

__all__ = ["EnclavePolicy", "Policy", "PolicyRule"]


class PolicyRule(NamedTuple):
    """One rule. `words` and `name` are what a person wrote, `rights` what it means on DDS; `profile` is '' in permissions."""

    allow: bool
    words: str
    name: str
    rights: tuple[Right, ...]
    place: Place
    profile: str = ""

    def __str__(self) -> str:
        return f"{self.words} {self.name}"


class EnclavePolicy(NamedTuple):
    """The rules of one enclave, in the order in which DDS tries them: the first that matches decides.

    `default_allow`: what holds where none does. `adds_discovery`: it is a policy, to which sros2 adds the rights on `ros_discovery_info`.
    """

    path: str
    place: Place
    rules: tuple[PolicyRule, ...] = ()
    profiles: tuple[str, ...] = ()
    default_allow: bool = False
    adds_discovery: bool = True


class Policy(NamedTuple):
    """All enclaves, by path; `findings` (RW403) say what could not be read, `notes` what is read but not compared."""

    enclaves: tuple[EnclavePolicy, ...]
    findings: tuple[Finding, ...] = ()
    notes: tuple[str, ...] = ()
