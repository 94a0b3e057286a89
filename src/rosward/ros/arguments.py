# SPDX-License-Identifier: Apache-2.0
"""What do the words of a command line mean to ROS?

    parse_arguments(["--speed", "2", "--ros-args", "-r", "cmd:=/left/cmd", "-p", "rate:=10"])
    -> remaps (cmd -> /left/cmd), parameters (/** rate = integer 10), user arguments ("--speed", "2")

The grammar is rcl's (arguments.c, lexer.c), which is stricter than it looks: `double__underscore` is no token, so a
rule with it is rejected. Values are typed as by rcl_yaml_param_parser (parse.c), which differs from YAML 1.1 and 1.2
and from PyYAML: `010` is octal 8, `08` is the double 8.0, `1e400` a string, `null` a string.

A `*` stands for an unknown part of a word (see `rosward.ros.names`). A word that it makes unreadable is in `unknown`,
not an error.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Final

from rosward.holes import HOLE, Holed, with_stars
from rosward.records import NamedTuple, dataclass, field
from rosward.ros.names import RemapKind, RemapRule, may_be_equal, validate_enclave
from rosward.ros.parameter_values import InvalidArgument, ParameterValue, effective_value, parse_value, scalar_value

__all__ = [
    "InvalidArgument",
    "ParameterRule",
    "ParameterValue",
    "ParamsFile",
    "Positions",
    "RosArguments",
    "effective_value",
    "key_fits_node",
    "parameters_of_node",
    "parse_arguments",
    "parse_parameter_rule",
    "parse_remap_rule",
    "parse_value",
    "scalar_value",
]


class ParameterRule(NamedTuple):
    """`-p node:name:=value`. `node` is the key as in a parameter file: `/**` without prefix, the bare name with one."""

    node: str
    name: str
    value: ParameterValue


class ParamsFile(NamedTuple):
    """`--params-file path`, as written."""

    path: str


class Positions(NamedTuple):
    """At which words the remap rules, the overrides and the enclave stand, and which words are the user's."""

    remaps: tuple[int, ...] = ()
    overrides: tuple[int, ...] = ()
    enclave: int | None = None
    user: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class RosArguments:
    """What rcl reads from a command line.

    `overrides` has parameters and parameter files in the order given, for the later ones win (but see
    `effective_value`). `enclave` is None without `--enclave`. `deprecated` are the remap rules found outside of
    `--ros-args`. With `errors` the real program ends at once; what could be read is here nevertheless. `unknown` are
    words that holes make unreadable: they may mean anything.
    """

    remaps: tuple[RemapRule, ...] = ()
    overrides: tuple[ParameterRule | ParamsFile, ...] = ()
    enclave: Holed | None = None
    rosout_logs: bool = True
    user_arguments: tuple[str, ...] = ()
    deprecated: tuple[str, ...] = ()
    errors: tuple[str, ...] = ()
    unknown: tuple[str, ...] = ()
    positions: Positions = field(default=Positions(), compare=False)

    @property
    def parameters(self) -> tuple[ParameterRule, ...]:
        """The parameters given by `-p`, in order."""
        return tuple(override for override in self.overrides if isinstance(override, ParameterRule))

    @property
    def params_files(self) -> tuple[str, ...]:
        """The paths given by `--params-file`, in order."""
        return tuple(override.path for override in self.overrides if isinstance(override, ParamsFile))


# Words

_FLAGS_WITH_VALUE: Final = {
    "-p": "parameter",
    "--param": "parameter",
    "-r": "remap",
    "--remap": "remap",
    "--params-file": "params file",
    "-e": "enclave",
    "--enclave": "enclave",
    "--log-level": "log level",
    "--log-config-file": "log file",
    "--log-file-name": "log file",
}
_FLAGS: Final = frozenset(
    ("--enable-stdout-logs", "--disable-stdout-logs", "--enable-external-lib-logs", "--disable-external-lib-logs")
)
_LOG_LEVEL: Final = re.compile(r"(?:(?:(?!:=).)+:=)?(?:unset|debug|info|warn|error|fatal)", re.IGNORECASE)


def parse_arguments(words: Sequence[Holed]) -> RosArguments:
    """Read the words of a command line, or the `cli_args` of a node, as rcl does (arguments.c).

    `words` may or may not begin with the name of the program. Only what stands between `--ros-args` and `--` (or the
    end) is for ROS; elsewhere every word of the form `x:=y` is a remap rule, too (deprecated), even after a user's
    own `--`.
    """
    remaps: list[RemapRule] = []
    overrides: list[ParameterRule | ParamsFile] = []
    enclave: Holed | None = None
    rosout_logs = True
    user: list[str] = []
    deprecated: list[str] = []
    errors: list[str] = []
    unknown: list[str] = []
    remaps_at: list[int] = []
    overrides_at: list[int] = []
    user_at: list[int] = []
    enclave_at: int | None = None
    for_ros = False
    pending = iter(enumerate(words))
    for at, word in pending:
        if word == "--ros-args":
            for_ros = True
        elif not for_ros:
            try:
                remaps.append(parse_remap_rule(word))
                remaps_at.append(at)
                deprecated.append(word)
            except InvalidArgument:
                user.append(word)
                user_at.append(at)
        elif word == "--":
            for_ros = False
        elif word in ("--enable-rosout-logs", "--disable-rosout-logs"):
            rosout_logs = word.startswith("--enable")
        elif word in _FLAGS_WITH_VALUE:
            behind = next(pending, None)
            if behind is None:
                errors.append(f"{word}: nothing after it")
                continue
            value_at, value = behind
            try:
                rule = _flag_value(_FLAGS_WITH_VALUE[word], value)
            except InvalidArgument as error:
                if HOLE in value:
                    unknown.append(with_stars(f"{word} {value}"))
                else:
                    errors.append(with_stars(f"{word} {value}: {error}"))
                continue
            if isinstance(rule, RemapRule):
                remaps.append(rule)
                remaps_at.append(value_at)
            elif isinstance(rule, _Enclave):
                enclave, enclave_at = rule.path, value_at
            elif rule is not None:
                overrides.append(rule)
                overrides_at.append(value_at)
        elif word not in _FLAGS:
            if HOLE in word:
                unknown.append(with_stars(word))
            else:
                errors.append(with_stars(f"{word}: unknown ROS argument"))
    reason = None if enclave is None else validate_enclave(enclave)
    if reason is not None:
        errors.append(with_stars(f"--enclave {enclave}: {reason}"))
    return RosArguments(
        tuple(remaps),
        tuple(overrides),
        enclave,
        rosout_logs,
        tuple(user),
        tuple(deprecated),
        tuple(errors),
        tuple(unknown),
        Positions(tuple(remaps_at), tuple(overrides_at), enclave_at, tuple(user_at)),
    )


class _Enclave(NamedTuple):
    path: Holed


def _flag_value(what: str, value: Holed) -> RemapRule | ParameterRule | ParamsFile | _Enclave | None:
    """The word after a flag; None for something about logging."""
    if what == "remap":
        return parse_remap_rule(value)
    if what == "parameter":
        return parse_parameter_rule(value)
    if what == "params file":
        return ParamsFile(with_stars(value))
    if what == "enclave":
        return _Enclave(value)
    if what == "log level" and HOLE not in value and not _LOG_LEVEL.fullmatch(value):
        raise InvalidArgument("not a log level")
    return None


# Rules

# The lexemes of lexer.c, tried in this order. A hole may stand wherever a letter may.
_LEXEME: Final = re.compile(
    r"""(?P<topic>rostopic://) | (?P<service>rosservice://) | (?P<ns>__ns) | (?P<node>__node|__name)
      | (?P<token>(?:_(?!_)|(?=[A-Za-z*]))(?:[A-Za-z0-9*]+(?:_[A-Za-z0-9*]+)*_?)?)
      | (?P<tilde>~/) | (?P<slash>/) | (?P<dot>\.) | (?P<separator>:=) | (?P<colon>:)""",
    re.VERBOSE,
)
_NODE_PREFIX: Final = re.compile(r"token colon ")
_PARAMETER_NAME: Final = re.compile(r"((?:token |slash )+(?:dot (?:token |slash )+)*)separator ")
_NAME: Final = r"((?:tilde |slash )?token (?:slash token )*)"
_NAME_RULE: Final = re.compile(rf"(topic |service )?{_NAME}separator {_NAME}")
_NODE_RULE: Final = re.compile(r"node separator (token )")
_NAMESPACE_RULE: Final = re.compile(r"ns separator ((?:slash )?(?:token slash )*(?:token )?)")


class _Lexed(NamedTuple):
    """A rule as the kinds of its lexemes, each with a space after it, and the text of each."""

    kinds: str
    texts: tuple[Holed, ...]

    def text(self, start: int, end: int) -> Holed:
        """The source of what stands between two offsets of `kinds`."""
        first = self.kinds.count(" ", 0, start)
        return Holed("".join(self.texts[first : first + self.kinds.count(" ", start, end)]))


def _lex(rule: Holed) -> _Lexed:
    kinds: list[str] = []
    texts: list[Holed] = []
    position = 0
    while position < len(rule):
        found = _LEXEME.match(rule, position)
        kinds.append("none" if found is None or found.lastgroup is None else found.lastgroup)
        texts.append(Holed(rule[position] if found is None else found[0]))
        position += len(texts[-1])
    return _Lexed("".join(f"{kind} " for kind in kinds), tuple(texts))


def parse_remap_rule(rule: Holed) -> RemapRule:
    """Read `[node:]match:=target`, `[node:]__node:=name` or `[node:]__ns:=/namespace`. Raises `InvalidArgument`."""
    lexed = _lex(rule)
    prefix = _NODE_PREFIX.match(lexed.kinds)
    start = prefix.end() if prefix else 0
    node = lexed.texts[0] if prefix else None
    found = _NODE_RULE.fullmatch(lexed.kinds, start)
    if found:
        return RemapRule(node, RemapKind.NODE, Holed(""), lexed.text(*found.span(1)))
    found = _NAMESPACE_RULE.fullmatch(lexed.kinds, start)
    if found and lexed.text(*found.span(1)).startswith(("/", HOLE)):
        return RemapRule(node, RemapKind.NAMESPACE, Holed(""), lexed.text(*found.span(1)))
    found = _NAME_RULE.fullmatch(lexed.kinds, start)
    if found:
        kind = RemapKind(found[1].strip()) if found[1] else RemapKind.BOTH
        return RemapRule(node, kind, lexed.text(*found.span(2)), lexed.text(*found.span(3)))
    raise InvalidArgument("not a remap rule")


def parse_parameter_rule(rule: Holed) -> ParameterRule:
    """Read `[node:]name:=value`; `node` is a bare name, `/ns/node:name:=value` an error. Raises `InvalidArgument`."""
    lexed = _lex(Holed(rule.partition(":=")[0] + ":=") if ":=" in rule else rule)
    prefix = _NODE_PREFIX.match(lexed.kinds)
    found = _PARAMETER_NAME.fullmatch(lexed.kinds, prefix.end() if prefix else 0)
    if not found:
        raise InvalidArgument("not a parameter rule")
    node = lexed.texts[0] if prefix else "/**"
    return ParameterRule(node, lexed.text(*found.span(1)), parse_value(Holed(rule.partition(":=")[2])))


def key_fits_node(key: str, node_fqn: Holed) -> bool | None:
    """Whether a key (`/**`, `/*/arm`, `arm`, `/left/arm`) is for the node `node_fqn`; None if a hole leaves it open.

    A key without leading `/` gets one: `arm` is for `/arm` only (rclpy node.cpp). The `*` of a key are wildcards,
    those of `node_fqn` are holes.
    """
    key = key if key.startswith("/") else f"/{key}"
    if HOLE in node_fqn:
        # `/**` covers all; of any other key with wildcards it is only known that it may fit
        return True if key == "/**" else None if may_be_equal(Holed(key.replace("/*", HOLE)), node_fqn) else False
    return _matches(key, node_fqn)


_KEY_PART: Final = re.compile(r"/\*\*|/\*|.", re.DOTALL)


def _matches(key: str, fqn: str) -> bool:
    """Whether rcl's pattern of the key (`/*` is one token, `/**` any number) is the whole name: place by place, since a regular
    expression would try every division of the name among the `/**` of a key."""
    token = [0] * (len(fqn) + 1)  # where the token that begins behind the slash at a place ends at the latest
    for at in range(len(fqn) - 1, -1, -1):
        token[at] = at if not _is_word(fqn[at]) else max(token[at + 1], at + 1)
    reached = {0}
    for part in _KEY_PART.findall(key):
        if part == "/*":
            reached = {end for at in reached for end in _tokens_at(fqn, at, token)}
        elif part == "/**":
            new = set(reached)
            while new:
                new = {end for at in new for end in _tokens_at(fqn, at, token)} - reached
                reached |= new
        else:
            reached = {at + 1 for at in reached if fqn[at : at + 1] == part}
        if not reached:
            return False
    return len(fqn) in reached


def _tokens_at(fqn: str, at: int, token: list[int]) -> range:
    """Where `/` and a word from `at` on may end."""
    return range(at + 2, token[at + 1] + 1) if fqn[at : at + 1] == "/" else range(0)


def _is_word(character: str) -> bool:
    return character.isascii() and (character.isalnum() or character == "_")


def parameters_of_node(rules: Iterable[ParameterRule], node_fqn: Holed) -> dict[str, ParameterValue]:
    """The initial values that `rules`, in the order of the command line, give the node `node_fqn`.

    rcl gathers the rules by key, a key standing where it was first seen; later keys win (rclpy node.cpp). So after
    `-p arm:x:=1 -p x:=2 -p arm:x:=3` it is the 2 that holds. Rules for a node (`cli_args`) are a call of their own, and
    win. A value is unknown if it depends on a hole in `node_fqn` whether its key fits.
    """
    by_key: dict[str, dict[str, list[ParameterValue]]] = {}
    for rule in rules:
        by_key.setdefault(rule.node, {}).setdefault(rule.name, []).append(rule.value)
    found: dict[str, ParameterValue] = {}
    for key, values in by_key.items():
        fits = key_fits_node(key, node_fqn)
        if fits is False:
            continue
        for name, given in values.items():
            value = effective_value(given)
            found[name] = value if fits or found.get(name) == value else ParameterValue(None, None)
    return found
