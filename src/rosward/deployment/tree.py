# SPDX-License-Identifier: Apache-2.0
"""What a launch file says, in one form for Python, XML and YAML.

    Node(package='demo', executable='talker', name=['talker_', LaunchConfiguration('id')])
    <node pkg="demo" exec="talker" name="talker_$(var id)"/>
    ->  StartNode(package=(Const('demo'),), …, name=(Const('talker_'), Substitution('var', ((Const('id'),),))))

Nothing here is decided yet: substitutions are not performed, conditions not tested, files not included: see `deployment/execution`.
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import TYPE_CHECKING, final

from rosward.records import NamedTuple

if TYPE_CHECKING:
    from rosward.domain.values import Value
    from rosward.location import Place


class Substitution(NamedTuple):
    """Text that is known when the launch file is executed. `kind` is the word of the XML form where there is one.

    var(name[, default]) · env(name[, default]) · find-pkg-share(package) · find-pkg-prefix(package) · exec-in-pkg(executable, package) ·
    find-exec(name) · dirname() · filename() · launch-log-dir() · anon(name) · eval(expression[, modules…]) · command(line[, on_stderr]) ·
    param(name) · not(a) · and(a, b) · or(a, b) · any(a…) · all(a…) · equals(a, b) · not-equals(a, b) · if(condition, then, else) ·
    file-content(path) · path-join(part…) · string-join(delimiter, part…) · local(expression) · for-var(name[, default]) · index(name[, default]) ·
    parameter-file(path, allow_substs) · replace-string(source_file) with tables[0] the replacements ·
    rewritten-yaml(source_file, root_key, convert_types) with tables of param_rewrites, key_rewrites and value_rewrites ·
    has-node-params(source_file, key) · as-bool(text): 'True' or 'False' · holds(): whether the condition `value` does ·
    python(): a substitution class of the analysed sources; `value` is the object, its `perform(context)` is called.
    """

    kind: str
    arguments: tuple[Template, ...]
    place: Place
    value: Value | None = None
    tables: tuple[tuple[tuple[Template, Template], ...], ...] = ()


Template = tuple["Value | Substitution", ...]
"""Text in pieces that are performed and concatenated. A piece that is a Value is the text itself (it may have holes or alternatives)."""


# Parameters


class Literal(NamedTuple):
    """A value that is used as it is: a plain str stays a str. Scalars are Const, lists are domain `Tuple`s of them, anything else unknown."""

    value: Value


class Typed(NamedTuple):
    """Text that is read as YAML once it is performed; `type` forces one: str, int, float, bool, yaml, or one of these in `List[…]`."""

    text: Template
    type: str | None = None


class Several(NamedTuple):
    """A list whose elements are each evaluated."""

    items: tuple[ParameterData, ...]


ParameterData = Literal | Typed | Several


class ParameterTable(NamedTuple):
    """A dict in `parameters=[…]`, or the <param> tags of a node: dotted names, in order (nested dicts are flattened)."""

    entries: tuple[tuple[Template, ParameterData], ...]
    place: Place


class ParameterFile(NamedTuple):
    """A path in `parameters=[…]`, or <param from="…">. `substitutions`: the file's own text may hold $(…)."""

    path: Template
    place: Place
    substitutions: bool = False


class ParameterArgument(NamedTuple):
    """A `launch_ros.parameter_descriptions.Parameter`, given to the node as -p."""

    name: Template
    data: ParameterData
    place: Place


ParameterSource = ParameterTable | ParameterFile | ParameterArgument


# Conditions


class Condition(NamedTuple):
    """When an action is executed. `kind`: if(text) · unless(text) · equals(name, text) · not-equals(name, text) ·
    python(): `value` is a condition object of the analysed sources, or a function of the context.
    """

    kind: str
    arguments: tuple[Template, ...]
    place: Place
    value: Value | None = None


# Actions


@dataclass(frozen=True, slots=True, kw_only=True)
class LaunchAction:
    """One entry of a launch description; `place` is where it is written. `identity` is the object of the launch file that it was read
    from, where there is one: event handlers name it as their target. `several`: it stands for more than one object.
    """

    place: Place
    condition: Condition | None = None
    identity: Value | None = None
    several: bool = False


class NodeKind(enum.Enum):
    """What a StartNode starts."""

    NODE = "node"
    LIFECYCLE = "lifecycle"
    CONTAINER = "container"


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Component:
    """A ComposableNode."""

    package: Template
    plugin: Template
    name: Template | None = None
    namespace: Template | None = None
    remappings: tuple[tuple[Template, Template], ...] = ()
    parameters: tuple[ParameterSource, ...] = ()
    extra_arguments: tuple[ParameterSource, ...] = ()
    place: Place
    condition: Condition | None = None


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class StartNode(LaunchAction):
    """Node, LifecycleNode, ComposableNodeContainer. `executable` alone, without a package, is a path."""

    kind: NodeKind = NodeKind.NODE
    package: Template | None = None
    executable: Template = ()
    name: Template | None = None
    namespace: Template | None = None
    remappings: tuple[tuple[Template, Template], ...] = ()
    parameters: tuple[ParameterSource, ...] = ()
    arguments: tuple[Template, ...] = ()
    ros_arguments: tuple[Template, ...] = ()
    exec_name: Template | None = None
    prefix: Template | None = None
    environment: tuple[tuple[Template, Template], ...] = ()
    replaces_environment: bool = False
    components: tuple[Component, ...] = ()
    on_exit: tuple[LaunchAction, ...] = ()


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class StartProcess(LaunchAction):
    """ExecuteProcess, ExecuteLocal: a command line in words. `shell`: each word is split again by a shell."""

    command: tuple[Template, ...]
    shell: bool = False
    environment: tuple[tuple[Template, Template], ...] = ()
    replaces_environment: bool = False
    on_exit: tuple[LaunchAction, ...] = ()


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class LoadComponents(LaunchAction):
    """LoadComposableNodes. `target` is a name, or the StartNode that is the container."""

    target: Template | StartNode
    components: tuple[Component, ...]


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Include(LaunchAction):
    """IncludeLaunchDescription: a file by path (`format` python, xml, yaml, any), or a description made in place (`body`).

    `loader` is the object that loads the file, where it is one: launch loads it once, so that each include of it has the same actions.
    """

    path: Template | None
    format: str = "any"
    arguments: tuple[tuple[Template, Template], ...] = ()
    body: tuple[LaunchAction, ...] = ()
    loader: Value | None = None


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Group(LaunchAction):
    """GroupAction. `configurations` are its launch_configurations."""

    actions: tuple[LaunchAction, ...]
    scoped: bool = True
    forwarding: bool = True
    configurations: tuple[tuple[Template, Template], ...] = ()


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Maybe(LaunchAction):
    """Actions of which each may or may not be there, because the Python around them depends on something unknown (`why`)."""

    actions: tuple[LaunchAction, ...]
    why: str


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Declare(LaunchAction):
    """DeclareLaunchArgument. `default` None: required."""

    name: Template
    default: Template | None = None
    choices: tuple[Template, ...] | None = None
    description: Template = ()


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class SetConfiguration(LaunchAction):
    """SetLaunchConfiguration, <let>; `value` None: UnsetLaunchConfiguration."""

    name: Template
    value: Template | None


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Environ(LaunchAction):
    """Set-, Unset- and AppendEnvironmentVariable: `how` is set, unset, append, prepend."""

    how: str
    name: Template
    value: Template = ()
    separator: Template = ()


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class ScopeChange(LaunchAction):
    """Push-, Pop- and ResetLaunchConfigurations and -Environment: `what` is configurations or environment, `how` push, pop, reset.

    `configurations`: what ResetLaunchConfigurations keeps or sets.
    """

    what: str
    how: str
    configurations: tuple[tuple[Template, Template], ...] = ()


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class PushNamespace(LaunchAction):
    """PushRosNamespace."""

    namespace: Template


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class SetRemap(LaunchAction):
    """SetRemap."""

    source: Template
    target: Template


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class SetParameter(LaunchAction):
    """SetParameter and SetParametersFromFile (a ParameterFile; `node` limits it)."""

    parameter: ParameterSource
    node: Template | None = None


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Timer(LaunchAction):
    """TimerAction, RosTimer: executed later, when groups around it are closed."""

    period: Template
    actions: tuple[LaunchAction, ...]


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class OnEvent(LaunchAction):
    """RegisterEventHandler with one of the event handlers. `event` is process-start, process-exit, process-io, execution-complete,
    shutdown, lifecycle (OnStateTransition), include-complete, other. `function` is a callable of (event, context) that gives more actions.
    `target`: what the handler waits for, where it says so (it decides whether the event can come).
    """

    event: str
    actions: tuple[LaunchAction, ...] = ()
    function: Value | None = None
    target: Value | None = None


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Opaque(LaunchAction):
    """OpaqueFunction, and actions of classes of the analysed sources: `function(context, *args, **kwargs)` gives more actions."""

    function: Value
    args: tuple[Value, ...] = ()
    kwargs: tuple[tuple[str, Value], ...] = ()


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Added(LaunchAction):
    """The end of a launch description: what functions have added to it (`description`) while launch went through it comes here."""

    description: Value


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class ForEach(LaunchAction):
    """ForEach and ForLoop. `values`: rows `{name: value, …};…` of YAML as text (ForEach), or (`count`) a number of turns (ForLoop).

    `function` gives the actions of one turn (called with the variables as keywords, ForLoop with the index as `i`); XML has a body instead, in
    which $(for-var NAME) and $(index NAME) stand for the values of the turn.
    """

    values: Template
    count: bool = False
    function: Value | None = None
    body: tuple[LaunchAction, ...] = ()
    index_name: str = ""


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Inert(LaunchAction):
    """An action that starts nothing and sets nothing for what is started: LogInfo, EmitEvent, Shutdown, SetROSLogDir,
    SetUseSimTime (it is about launch's own node), … `kind` is its class or tag."""

    kind: str


@final
@dataclass(frozen=True, slots=True, kw_only=True)
class Unread(LaunchAction):
    """Something that nobody could read: told as a finding (RW321) with `why`, because it may start anything."""

    why: str


class Description(NamedTuple):
    """A launch file that was read."""

    actions: tuple[LaunchAction, ...]
    file: str
