# SPDX-License-Identifier: Apache-2.0
"""Which commands are there, and which module declares and runs each?

A new command is an entry here and a module with `add(parser)`, which declares its options and the function that runs it. The module is imported
only where its command is asked for, so that the others answer at once.
"""

from typing import Final

from rosward.records import NamedTuple

__all__ = ["COMMANDS", "Command"]


class Command(NamedTuple):
    """The module of a command, below `rosward.cli`, and what the command is for, in a line of `rosward --help`."""

    module: str
    what: str


COMMANDS: Final = {
    "extract": Command("extract", "write the graph, the policies and a report"),
    "list": Command("listing", "print nodes, topics, services, actions, packages or parameters as a table"),
    "explain": Command("explain", "explain why a name is in the result"),
    "flow": Command("flow", "show what each output is made of"),
    "declare": Command("declare", "create a declaration of a node that is not analysed (RW314)"),
    "check": Command("check", "check an existing policy against the sources"),
    "diff": Command("diff", "compare two commits, folders, networks or policies"),
    "enclaves": Command("enclaves", "suggest which processes can share an enclave, and at what price"),
    "launch-tree": Command("launch_tree", "print what launch files start"),
    "nodl": Command("nodl", "write the interface of an executable as NoDL"),
    "snapshot": Command("snapshot", "record the graph of a running robot"),
    "audit": Command("audit", "compare a running robot with its sources"),
    "survey": Command("survey", "analyse many repositories and write tables (Parquet)"),
    "serve": Command("serve", "analyse sources on a page in the browser"),
    "watch": Command("watch", "extract, and again whenever the sources change"),
    "lsp": Command("lsp", "serve an editor: findings and names while you type"),
    "completion": Command("completion_script", "print a shell completion script"),
}
"""By name, in the order of `rosward --help`."""
