# SPDX-License-Identifier: Apache-2.0
"""The architecture, enforced: imports point one way, modules stay small, nothing that changes lives in a module.

source ── ir ── frontends
          domain ── effects ── naming ── models ── engine ── deployment ── analysis ── pipeline ── cli, server, surveying
          ros ── network ── influence, policies ── enclaves, audit, diff ── explanation ── outputs ──┘
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Final, NamedTuple

ROOT: Final = Path(__file__).parent.parent / "src" / "rosward"
LONGEST: Final = 400

_FINDINGS = frozenset({"findings", "rules", "location", "records"})
_TEXT = frozenset({"source", "one_cause", "guard", "holes", "safe"}) | _FINDINGS
_DOMAIN = frozenset({"domain", "ir"}) | _TEXT
_NAMING = frozenset({"naming", "effects", "ros"}) | _DOMAIN
_ENGINE = frozenset({"engine", "models", "frontends", "ir", "deadline"}) | _NAMING
_NETWORK = frozenset({"network", "ros"}) | _TEXT
_POLICIES = frozenset({"policies"}) | _NETWORK
_RESULT = frozenset({"enclaves", "audit", "diff", "explanation", "influence", "suppression"}) | _POLICIES

ALLOWED: Final[dict[str, frozenset[str]]] = {
    "holes": frozenset(),
    "safe": frozenset(),
    "confined": frozenset(),
    "records": frozenset(),
    "deadline": frozenset(),
    "source": _TEXT | {"_version"},
    "location": frozenset({"records"}),
    "findings": _FINDINGS,
    "rule": frozenset({"records"}),
    "rules": frozenset({"rule", "rules_of_systems"}),
    "rules_of_systems": frozenset({"rule"}),
    "one_cause": _FINDINGS,
    "guard": _FINDINGS,
    "ir": frozenset({"ir"}) | _TEXT,
    "frontends": frozenset({"frontends", "ir"}) | _TEXT,
    "domain": _DOMAIN,
    "ros": frozenset({"ros"}) | _TEXT,
    "effects": frozenset({"effects", "ros"}) | _DOMAIN,
    "naming": _NAMING,
    "models": frozenset({"models"}) | _NAMING,
    "engine": _ENGINE,
    "network": _NETWORK,
    "flow": frozenset({"flow"}) | _ENGINE,
    "deployment": frozenset({"deployment", "network"}) | _ENGINE,
    "analysis": frozenset({"analysis", "cache", "deployment", "flow", "network"}) | _ENGINE,
    "policies": _POLICIES,
    "suppression": frozenset({"suppression"}) | _TEXT,
    "enclaves": frozenset({"enclaves", "influence"}) | _POLICIES,
    "result": _NETWORK,
    "cache": frozenset({"cache", "result", "_version"}) | _NETWORK,
    "audit": frozenset({"audit"}) | _POLICIES,
    "influence": frozenset({"influence"}) | _NETWORK,
    "diff": frozenset({"diff"}) | _POLICIES,
    "explanation": frozenset({"explanation", "enclaves", "influence", "suppression"}) | _POLICIES,
    "declaring": frozenset({"declaring", "audit"}) | _POLICIES,
    "git": frozenset({"git", "records"}),
    "outputs": frozenset({"outputs", "_version"}) | _RESULT,
    "pipeline": frozenset({"analysis", "cache", "deployment", "enclaves", "network", "result"}) | _ENGINE,
    "cli": frozenset(
        {
            "cli",
            "analysis",
            "cache",
            "declaring",
            "deployment",
            "git",
            "lsp",
            "outputs",
            "pipeline",
            "result",
            "server",
            "surveying",
            "_version",
        }
    )
    | _RESULT,
    "surveying": frozenset(
        {"surveying", "confined", "deployment", "network", "outputs", "pipeline", "result", "ros", "_version"}
    )
    | _TEXT,
    "server": frozenset({"server", "confined", "analysis", "deployment", "outputs", "pipeline", "_version"})
    | _RESULT
    | _ENGINE,
    "lsp": frozenset({"lsp", "analysis", "deployment", "network", "pipeline", "result", "suppression", "_version"})
    | _ENGINE,
    "__init__": frozenset({"pipeline", "_version", "network", "surveying"}) | _ENGINE,
    "__main__": frozenset({"cli"}),
    "ros2_security": frozenset({"cli"}),
    "_version": frozenset(),
}
"""What each folder (or module at the top) may import, also where only type checkers read it."""

ON_DEMAND: Final = {
    ("pipeline.py", "rosward.analysis.launched"),
    ("analysis/read.py", "rosward.analysis.compiled"),
    ("analysis/read.py", "rosward.analysis.kept_programs"),
    ("analysis/read.py", "rosward.analysis.models_state"),
    ("analysis/read.py", "rosward.analysis.summaries"),
    ("analysis/read.py", "rosward.cache.version"),
    ("analysis/process.py", "rosward.analysis.linked"),
    ("analysis/process.py", "rosward.flow.process"),
    ("analysis/process.py", "rosward.engine.watching.watch"),
    ("analysis/runner.py", "rosward.analysis.known"),
    ("analysis/runner.py", "rosward.analysis.models_state"),
    ("analysis/runner.py", "rosward.analysis.outcome_form"),
    ("analysis/runner.py", "rosward.analysis.workers"),
    ("analysis/runner.py", "rosward.cache.codec"),
    ("analysis/runner.py", "rosward.cache.version"),
    ("analysis/unreached.py", "rosward.analysis.unreached_linked"),
    ("analysis/source_tree.py", "rosward.source.parameter_module"),
    ("analysis/source_tree.py", "rosward.source.yaml_nodes"),
    ("source/discover.py", "rosward.source.packages"),
    ("ir/registers.py", "rosward.ir.cpp_registers"),
    ("deployment/given.py", "rosward.deployment.parameter_files"),
    ("outputs/report/page.py", "rosward.outputs.report.frame"),
    ("surveying/one.py", "rosward.deployment.request"),
    ("surveying/one.py", "rosward.guard"),
    ("surveying/one.py", "rosward.pipeline"),
    ("surveying/one.py", "rosward.rules"),
    ("surveying/one.py", "rosward.surveying.rows"),
    ("surveying/run.py", "rosward.surveying.tables"),
}
"""What is imported in a function because most runs do not need it."""

_PROCEDURES: Final = frozenset({"list", "dict", "set", "defaultdict", "OrderedDict", "deque", "Counter", "bytearray"})
_DISPLAYS: Final = (ast.List, ast.Dict, ast.Set, ast.ListComp, ast.DictComp, ast.SetComp)
_MAY_CHANGE: Final = re.compile(r"\bglobal\b|cache\b")
"""What stands in every text that says `global`, or keeps what a function returned."""
_CONSTANT: Final = re.compile(r"_?[A-Z][A-Z0-9_]*|__\w+__")


class Use(NamedTuple):
    """One import of a module of rosward: where, of what, and whether it stands in a function."""

    file: str
    line: int
    target: str
    inside: bool


class Module(NamedTuple):
    """What is to be known of a module; its tree is not kept, as there are many."""

    file: str
    lines: list[str]
    docstring: str
    uses: list[Use]
    changing: list[str]


@cache
def modules() -> tuple[Module, ...]:
    """All modules, each read once."""
    return tuple(_module(p) for p in sorted(ROOT.rglob("*.py")) if "__pycache__" not in p.parts)


def _module(path: Path) -> Module:
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text)
    uses = list(_walk(tree.body, name_of(path), inside=False))
    return Module(name_of(path), text.splitlines(), ast.get_docstring(tree) or "", uses, list(_changing(tree, text)))


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def dotted_name(file: str) -> str:
    return "rosward." + file.removesuffix(".py").replace("/", ".").removesuffix(".__init__")


def layer_of(file: str) -> str:
    return file.partition("/")[0].removesuffix(".py")


def _is_module(dotted: str) -> bool:
    path = ROOT.parent.joinpath(*dotted.split("."))
    return path.is_dir() or path.with_suffix(".py").is_file()


def _targets(node: ast.AST) -> Iterator[str]:
    """The modules that a statement imports; `from rosward.engine import calls` imports rosward.engine.calls."""
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
    elif isinstance(node, ast.ImportFrom):
        assert node.level == 0, "relative import"
        inner = [f"{node.module}.{alias.name}" for alias in node.names]
        yield from dict.fromkeys(i if _is_module(i) else str(node.module) for i in inner)


def _walk(body: list[ast.stmt], file: str, *, inside: bool) -> Iterator[Use]:
    for node in body:
        deeper = inside or isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))
        for target in _targets(node):
            if target.partition(".")[0] == "rosward":
                yield Use(file, node.lineno, target, inside)
        for field in ("body", "orelse", "finalbody", "handlers", "cases"):
            inner = getattr(node, field, None)
            if isinstance(inner, list):
                yield from _walk(inner, file, inside=deeper)


def uses() -> Iterator[Use]:
    for module in modules():
        yield from module.uses


def _layer_of_target(target: str) -> str:
    return target.split(".")[1] if "." in target else "__init__"


def _told(found: list[str]) -> str:
    return "\n" + "\n".join(found)


def test_every_part_has_its_place() -> None:
    """A new folder or module at the top is entered in `ALLOWED` (and in docs/architecture.md)."""
    assert {layer_of(module.file) for module in modules()} <= set(ALLOWED)


def test_imports_point_one_way() -> None:
    wrong = [
        f"{use.file}:{use.line} imports {use.target}"
        for use in uses()
        if _layer_of_target(use.target) not in ALLOWED[layer_of(use.file)]
    ]
    assert not wrong, _told(wrong)


def test_the_engine_asks_a_language_by_its_record_alone() -> None:
    """What is Python's own stands in `engine/python`; only the list of languages names its record, and a language that is made of parts of it."""
    wrong = [
        f"{use.file}:{use.line} imports {use.target}"
        for use in uses()
        if use.file.startswith("engine/") and not use.file.startswith(("engine/python/", "engine/cpp/"))
        if use.target.startswith("rosward.engine.python.") and use.file != "engine/languages.py"
    ]
    assert not wrong, _told(wrong)


def test_a_front_end_is_reached_by_the_registry_alone() -> None:
    """Which one reads a file is a matter of its suffix."""
    wrong = [
        f"{use.file}:{use.line} imports {use.target}"
        for use in uses()
        if not use.file.startswith("frontends/") and use.target.startswith("rosward.frontends.python_")
    ]
    assert not wrong, _told(wrong)


def test_no_import_hides_in_a_function_to_break_a_cycle() -> None:
    """Only the command line imports late, so that `--help` and `--version` answer at once."""
    late = [u for u in uses() if u.inside and layer_of(u.file) != "cli" and (u.file, u.target) not in ON_DEMAND]
    hidden = [f"{u.file}:{u.line} imports {u.target}" for u in late]
    assert not hidden, _told(hidden)


def test_modules_do_not_import_each_other() -> None:
    """No cycle among modules, whatever their layer, and be it for types alone."""
    graph: dict[str, set[str]] = {}
    for use in uses():
        graph.setdefault(dotted_name(use.file), set()).add(use.target)
    cycles = [" -> ".join(cycle) for cycle in (_cycle(graph, module) for module in sorted(graph)) if cycle]
    assert not cycles, _told(cycles)


def test_folders_do_not_import_each_other() -> None:
    """What stands in one folder, modules and folders alike, has an order: no folder imports what imports something of it."""
    rooms: dict[str, dict[str, set[str]]] = {}
    for use in uses():
        here, there = dotted_name(use.file).split("."), use.target.split(".")
        common = next((n for n, (a, b) in enumerate(zip(here, there, strict=False)) if a != b), 0)
        if common:
            inside = rooms.setdefault(".".join(here[:common]), {})
            inside.setdefault(here[common], set()).add(there[common])
    cycles = [
        f"{room}: {' -> '.join(cycle)}"
        for room, graph in sorted(rooms.items())
        for cycle in (_cycle(graph, start) for start in sorted(graph))
        if cycle
    ]
    assert not cycles, _told(cycles)


def _cycle(graph: dict[str, set[str]], start: str) -> list[str]:
    """The shortest way from a module back to itself; empty where there is none."""
    before: dict[str, str] = {}
    queue = [start]
    for module in queue:
        for target in sorted(graph.get(module, ())):
            if target == start:
                way = [module]
                while way[-1] != start:
                    way.append(before[way[-1]])
                return [*reversed(way), start]
            if target not in before:
                before[target] = module
                queue.append(target)
    return []


def test_a_module_is_short_and_says_what_it_is() -> None:
    wrong: list[str] = []
    for module in modules():
        if module.lines[0] != "# SPDX-License-Identifier: Apache-2.0":
            wrong.append(f"{module.file}: no license in the first line")
        if len(module.lines) > LONGEST:
            wrong.append(f"{module.file}: {len(module.lines)} lines")
        if not module.docstring or not module.lines[1].startswith('"""'):
            wrong.append(f"{module.file}: a module opens with the question that it settles")
    assert not wrong, _told(wrong)


def test_nothing_that_changes_lives_in_a_module() -> None:
    """Lists, dicts and sets at module level are constants: named so, or `Final`; no function says `global`."""
    wrong = [f"{module.file}:{each}" for module in modules() for each in module.changing]
    assert not wrong, _told(wrong)


def _changing(tree: ast.Module, text: str) -> Iterator[str]:
    for node in tree.body:
        if isinstance(node, ast.AnnAssign) and "Final" not in ast.unparse(node.annotation):
            yield from _mutable([node.target], node.value)
        elif isinstance(node, ast.Assign):
            yield from _mutable(node.targets, node.value)
    for inner in ast.walk(tree) if _MAY_CHANGE.search(text) else ():
        if isinstance(inner, ast.Global):
            yield f"{inner.lineno}: global {', '.join(inner.names)}"
        elif isinstance(inner, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield from (f"{n.lineno}: {ast.unparse(n)[:60]}" for n in _caches(inner))


def _mutable(targets: list[ast.expr], value: ast.expr | None) -> list[str]:
    made = isinstance(value, _DISPLAYS) or (
        isinstance(value, ast.Call) and ast.unparse(value.func).rpartition(".")[2] in _PROCEDURES
    )
    names = [ast.unparse(t) for t in targets]
    return [f"{targets[0].lineno}: {n}" for n in names if made and not _CONSTANT.fullmatch(n)]


def _caches(function: ast.FunctionDef | ast.AsyncFunctionDef) -> Iterator[ast.expr]:
    """Decorators that keep what a function once returned: state of the module by another name."""
    for decorator in function.decorator_list:
        if ast.unparse(decorator).partition("(")[0].rpartition(".")[2] in {"cache", "lru_cache"}:
            yield decorator


_STUB_FOLDER: Final = ROOT / "models" / "stubs"


def test_stubs_open_like_modules() -> None:
    wrong: list[str] = []
    for path in sorted(_STUB_FOLDER.rglob("*.pyi")):
        text = path.read_text(encoding="utf-8")
        if not text.startswith("# SPDX-License-Identifier: Apache-2.0\n") or not ast.get_docstring(ast.parse(text)):
            wrong.append(path.relative_to(ROOT).as_posix())
    assert not wrong, _told(wrong)


_WORDS_OF_ROS: Final = re.compile(
    r"rclpy|rclcpp|tf2|ament|\bros\b|ROS|\blaunch|create_|declare_parameter|\bNode\b|[Tt]opic|std_msgs"
)
"""Words by which ROS would be known in the engine. A node, as a thing that effects speak of, is none of them."""


def _code_without_docs(text: str) -> str:
    """A module without comments, docstrings and imports."""
    tree = ast.parse(text)
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            kept = [s for s in body if not isinstance(s, (ast.Import, ast.ImportFrom)) and not _is_text(s)]
            node.body = kept or [ast.Pass()]  # type: ignore[attr-defined]
    return ast.unparse(tree)


def _is_text(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def test_the_engine_has_no_word_of_ros() -> None:
    """What it must know of client libraries, the marks of their stubs say (`models/facts.py`)."""
    texts = {m.file: "\n".join(m.lines) for m in modules() if m.file.startswith("engine/")}
    found = [
        f"{file}: {line.strip()}"
        for file, text in texts.items()
        for line in (_code_without_docs(text).splitlines() if _WORDS_OF_ROS.search(text) else ())
        if _WORDS_OF_ROS.search(line)
    ]
    assert not found, _told(found)
