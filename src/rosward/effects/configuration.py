# SPDX-License-Identifier: Apache-2.0
"""How a process is started: its command line, the parameter files that it names, its environment. All values are abstract.

    Configuration(words=(Const('--ros-args'), Const('-r'), Const('__node:=left'), Const('--params-file'), Const('/tmp/params 1')),
                  files={'/tmp/params 1': (Given('/**', 'rate', Const(10)),)})

`None` in place of a configuration: started by nobody knows whom, as `ros2 run` does it, with arguments that are not known.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, final

from rosward.records import NamedTuple, dataclass, field

if TYPE_CHECKING:
    from rosward.domain.unknown import Reason
    from rosward.domain.values import Value
    from rosward.location import Place


class Given(NamedTuple):
    """One parameter of a parameter file: `node` is the key as rcl has it (`/**`, `/*/arm`, `/left/arm`), `name` dotted.

    `value` is a Const (bool, int, float, str), a domain `Tuple` of them, or unknown. `name` '*' stands for any parameter (an unknown file part).
    `nested`: its name was made of nested keys. Such a parameter never joins an earlier one of its name, as others do (rcl parse.c): it replaces it.
    """

    node: str
    name: str
    value: Value
    place: Place | None = None
    nested: bool = False


@final
@dataclass(frozen=True, slots=True, eq=False)
class Configuration:
    """The start of one process. `words` are what stands behind the program's name: the program's own arguments and those of ROS.

    `files` holds, for each `--params-file` word as printed (`*` for holes), its content; None where it is not known, and `missing` says why.
    `environment` holds the variables that the deployment sets, None for those that it removes; others are as in the shell. `component`: the
    words that launch gives a component in this process, for its own node alone, which does not see those of the process.
    """

    words: tuple[Value, ...] = ()
    files: Mapping[str, tuple[Given, ...] | None] = field(default_factory=dict)
    missing: Mapping[str, Reason] = field(default_factory=dict)
    environment: Mapping[str, Value | None] = field(default_factory=dict)
    component: tuple[Value, ...] | None = None

    @property
    def own(self) -> tuple[Value, ...]:
        """The words that the first node of the program sees."""
        return self.words if self.component is None else self.component
