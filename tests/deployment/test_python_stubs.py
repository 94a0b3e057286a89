# SPDX-License-Identifier: Apache-2.0
"""The models of launch and its relatives can be loaded, each module by itself."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from sampling import sample

from deployment.python_tree import Files, Launch
from rosward.deployment.python.actions import Actions
from rosward.deployment.python.inert import INERT, NOT_READ
from rosward.deployment.python.objects import Objects
from rosward.deployment.python.substitutions import CONDITIONS, FORMS
from rosward.domain.compound import External
from rosward.domain.values import Class, ModuleValue, Unknown
from rosward.effects.log import EffectLog
from rosward.engine.budget import Budget
from rosward.engine.interpreter import Interpreter
from rosward.engine.libraries.library import Library
from rosward.engine.libraries.stub_files import STUBS
from rosward.models.tables import own_models

ACTION = "launch.action.Action"

FOLDERS = sorted(
    folder
    for folder in STUBS.iterdir()
    if folder.name.startswith("launch")
    or any(re.search(r"^\s*(from|import) launch\b", p.read_text("utf-8"), re.M) for p in folder.rglob("*.pyi"))
)
"""The models of launch, and of whatever makes actions or substitutions for it."""
MODULES = sorted(
    ".".join(path.relative_to(STUBS).with_suffix("").parts).removesuffix(".__init__")
    for folder in FOLDERS
    for path in folder.rglob("*.pyi")
)


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Files:
    return Files(tmp_path_factory.mktemp("stubs"), "")


@pytest.mark.parametrize("name", sample([*MODULES, "xacro"], 3))
def test_a_model_can_be_loaded(name: str, files: Files) -> None:
    """No name in it leads nowhere."""
    library = Library(files.tree, own_models())
    found = library.find(name, 0, None)
    assert found is not None
    assert found.model
    module = library.load_model(found)
    assert isinstance(module, ModuleValue)
    attrs = library.at(module.address).attrs
    lost = [
        n
        for n, v in attrs.items()
        if isinstance(v, (Unknown, External)) and not n.startswith("__") and not _from_models(v)
    ]
    assert not lost


def test_what_a_module_imports_can_be_imported_from_it(files: Files) -> None:
    """As editors suggest it: `from launch_ros.substitutions.find_package import get_package_share_directory`."""
    library = Library(files.tree, own_models())
    one, other = (
        library.find(n, 0, None) for n in ("launch_ros.substitutions.find_package", "ament_index_python.packages")
    )
    assert one is not None
    assert other is not None
    ours, theirs = (library.at(library.load_model(found).address).attrs for found in (one, other))
    for name in ("get_package_prefix", "get_package_share_directory"):
        assert ours[name] == theirs[name]


def _from_models(value: object) -> bool:
    """Functions for models, and names of the standard library that no model has."""
    return isinstance(value, External) and value.name.startswith(("_rosward", "typing."))


def test_each_action_of_a_model_is_read_or_known_to_start_nothing(files: Files) -> None:
    """None is skipped in silence: its own class, or the nearest that it derives from, stands in exactly one table."""
    library = Library(files.tree, own_models())
    machine = Interpreter(library, Budget(), EffectLog())
    tables = (set(Actions(Objects(machine)).readers), set(INERT), set(NOT_READ))
    classes = _derived_from(ACTION, library)
    assert len(classes) > 40
    skipped = []
    for dotted, cls in classes.items():
        if dotted == ACTION or cls.name.startswith("_"):
            continue
        ancestors = [c.dotted for c in cls.mro if isinstance(c, Class)]
        nearest = next((a for a in ancestors if any(a in table for table in tables)), None)
        if sum(nearest in table for table in tables) != 1:
            skipped.append(dotted)
    assert not skipped
    assert set().union(*tables) <= set(classes)


@pytest.mark.parametrize(
    ("base", "read"),
    [
        ("launch.substitution.Substitution", {*FORMS, "launch.substitutions.TextSubstitution"}),  # this one is its text
        ("launch.condition.Condition", set(CONDITIONS)),
    ],
)
def test_each_substitution_and_condition_of_a_model_has_a_form(base: str, read: set[str], files: Files) -> None:
    classes = _derived_from(base, Library(files.tree, own_models()))
    assert len(classes) > 3
    assert {c for c, cls in classes.items() if c != base and not cls.name.startswith("_")} <= read


def _derived_from(base: str, library: Library) -> dict[str, Class]:
    """The classes of the models that derive from one, by their dotted name."""
    classes: dict[str, Class] = {}
    for name in MODULES:
        found = library.find(name, 0, None)
        assert found is not None
        module = library.load_model(found)
        assert isinstance(module, ModuleValue)
        for value in library.at(module.address).attrs.values():
            if isinstance(value, Class) and any(isinstance(c, Class) and c.dotted == base for c in value.mro):
                classes[value.dotted] = value
    return classes


def test_what_stands_in_no_table_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosward.deployment.python.actions.INERT", frozenset[str]())
    text = "def generate_launch_description(): return LaunchDescription([LogInfo(msg='x')])"
    assert Files(tmp_path, text).shown(Launch()).strip() == "Unread why=LogInfo is not a known launch entity"


def test_an_action_that_derives_from_another_is_read_as_that_one(tmp_path: Path) -> None:
    """Those of ros_gz_sim and ros_gz_bridge include launch files."""
    text = """
    from ros_gz_bridge.actions import RosGzBridge
    from ros_gz_sim.actions import GzServer
    from moveit_configs_utils.launch_utils import DeclareBooleanLaunchArg
    from launch_testing.actions import GTest, ReadyToTest
    from launch_testing.util import KeepAliveProc

    def generate_launch_description():
        return LaunchDescription([
            RosGzBridge(bridge_name='b', config_file='c.yaml'), GzServer(world_sdf_file='w.sdf'),
            DeclareBooleanLaunchArg('sim', default_value=True), KeepAliveProc(), ReadyToTest(), GTest(path='x'),
        ])
    """
    lines = Files(tmp_path, text).shown(Launch()).splitlines()
    assert [line.split()[0] for line in lines] == ["Include", "Include", "Declare", "Timer", "Inert", "Unread"]
    assert "ros_gz_bridge.launch.py" in lines[0]
    assert "gz_server.launch.py" in lines[1]
