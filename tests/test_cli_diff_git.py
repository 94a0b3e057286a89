# SPDX-License-Identifier: Apache-2.0
"""`rosward diff --git`: two commits, or a commit and the work tree. Nothing that the repository configures runs; the work tree stays as it is."""

from __future__ import annotations

import json
import subprocess
from importlib import resources
from pathlib import Path

import jsonschema
import pytest

from rosward.cli import main

NODE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
{entities}rclpy.spin(node)
"""
CHATTER = 'node.create_publisher(String, "chatter", 10)\n'
STATUS = 'node.create_publisher(String, "status", 10)\n'


def git(*arguments: str) -> None:
    identity = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    subprocess.run(["git", *identity, *arguments], check=True, capture_output=True)


def talker(*entities: str) -> None:
    Path("src").mkdir(exist_ok=True)
    Path("src/talker.py").write_text(NODE.format(entities="".join(entities)), encoding="utf-8")


def commit(*entities: str) -> None:
    talker(*entities)
    git("add", "-A")
    git("commit", "-qm", "x", "--allow-empty")


@pytest.fixture(autouse=True)
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """One commit with a talker."""
    (tmp_path / "ws").mkdir()
    monkeypatch.chdir(tmp_path / "ws")
    monkeypatch.setenv("HOME", str(tmp_path))
    git("init", "-q", "-b", "main")
    commit(CHATTER)
    return tmp_path / "ws"


def gained(capsys: pytest.CaptureFixture[str], *arguments: str) -> list[str]:
    """The new rights, as `name place`."""
    capsys.readouterr()
    assert main(["diff", "--json", *arguments]) == 0
    document = json.loads(capsys.readouterr().out)
    schema = json.loads((resources.files("rosward.outputs") / "schemas" / "diff.schema.json").read_text())
    jsonschema.Draft202012Validator(schema).validate(document)
    return [f"{r['name']} {r['file']}:{r['line']}" for r in document["rights"]["gained"]]


def test_two_commits(capsys: pytest.CaptureFixture[str]) -> None:
    commit(CHATTER, STATUS)
    assert gained(capsys, "--git", "HEAD~1..HEAD") == ["/status src/talker.py:8"]
    assert gained(capsys, "--git", "HEAD~1..", "src") == ["/status talker.py:8"]
    assert gained(capsys, "--git", "HEAD..HEAD~1") == []
    assert main(["diff", "--git", "HEAD~1..HEAD", "--fail-on", "new-rights"]) == 1


def test_a_commit_and_the_work_tree(capsys: pytest.CaptureFixture[str]) -> None:
    """With what is not yet added, and without what is ignored."""
    talker(CHATTER, STATUS)
    Path("src/second.py").write_text(NODE.format(entities=STATUS).replace("talker", "second"), encoding="utf-8")
    Path("src/third.py").write_text(NODE.format(entities=STATUS).replace("talker", "third"), encoding="utf-8")
    Path(".gitignore").write_text("third.py\n", encoding="utf-8")
    found = gained(capsys, "--git", "HEAD")
    assert "/status src/talker.py:8" in found
    assert any(f.endswith("src/second.py:7") for f in found)
    assert not any("third" in f for f in found)


def test_three_dots_begin_at_the_common_ancestor(capsys: pytest.CaptureFixture[str]) -> None:
    """What came into main since is no difference of the branch."""
    git("checkout", "-qb", "feature")
    commit(CHATTER, STATUS)
    git("checkout", "-q", "main")
    commit()
    assert gained(capsys, "--git", "main...feature") == ["/status src/talker.py:8"]
    assert len(gained(capsys, "--git", "main..feature")) == 2


def test_moved_lines_are_no_difference(capsys: pytest.CaptureFixture[str]) -> None:
    talker("# one\n# two\n", CHATTER)
    assert main(["diff", "--git", "HEAD", "--fail-on", "new-rights"]) == 0
    assert capsys.readouterr().out == "No difference.\n"


def test_the_work_tree_stays_as_it_is(repository: Path) -> None:
    commit(CHATTER, STATUS)
    talker(STATUS)
    before = {p: p.stat().st_mtime_ns for p in sorted(repository.rglob("*")) if p.is_file()}
    assert main(["diff", "--git", "HEAD~1..HEAD"]) == 0
    assert main(["diff", "--git", "HEAD"]) == 0
    assert {p: p.stat().st_mtime_ns for p in sorted(repository.rglob("*")) if p.is_file()} == before


def test_nothing_that_the_repository_configures_is_run(tmp_path: Path) -> None:
    """Filters, textconv, an fsmonitor, hooks, an external diff, export-subst: each would leave a file behind."""
    trap = tmp_path / "trap"
    trap.write_text(f"#!/bin/sh\ntouch {tmp_path}/sprung\ncat\n", encoding="utf-8")
    trap.chmod(0o755)
    Path(".gitattributes").write_text("*.py filter=evil diff=evil export-subst\n", encoding="utf-8")
    commit(CHATTER, STATUS)
    for key in (
        "filter.evil.smudge",
        "filter.evil.clean",
        "filter.evil.process",
        "diff.evil.textconv",
        "diff.evil.command",
        "diff.external",
        "core.fsmonitor",
        "core.pager",
        "core.sshCommand",
        "core.alternateRefsCommand",
    ):
        git("config", key, str(trap))
    hooks = tmp_path / "hooks"
    hooks.mkdir()
    for hook in ("post-checkout", "post-index-change", "fsmonitor-watchman", "reference-transaction"):
        (hooks / hook).symlink_to(trap)
    git("config", "core.hooksPath", str(hooks))
    (tmp_path / "sprung").unlink(missing_ok=True)
    talker(CHATTER, STATUS, "# changed\n")
    assert main(["diff", "--git", "HEAD~1..HEAD"]) == 0
    assert main(["diff", "--git", "HEAD~1"]) == 0
    assert not (tmp_path / "sprung").exists()


def test_a_missing_object_is_not_fetched(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A partial clone asks its remote for what is missing, by any command that the configuration names."""
    trap = tmp_path / "trap"
    trap.write_text(f"#!/bin/sh\ntouch {tmp_path}/sprung\n", encoding="utf-8")
    trap.chmod(0o755)
    name = subprocess.run(
        ["git", "rev-parse", "HEAD:src/talker.py"], check=True, capture_output=True, text=True
    ).stdout.strip()
    Path(".git/objects", name[:2], name[2:]).unlink()
    for key, value in (
        ("core.repositoryFormatVersion", "1"),
        ("extensions.partialClone", "origin"),
        ("remote.origin.promisor", "true"),
        ("remote.origin.url", f"ext::{trap}"),
        ("remote.origin.uploadpack", str(trap)),
        ("protocol.ext.allow", "always"),
    ):
        git("config", key, value)
    assert main(["diff", "--git", "HEAD"]) == 2
    assert capsys.readouterr().err.startswith("rosward: --git: ")
    assert not (tmp_path / "sprung").exists()


def test_links_that_lead_out_are_not_followed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    secret = tmp_path / "secret"
    secret.mkdir()
    (secret / "spy.py").write_text(NODE.format(entities=STATUS).replace("talker", "spy"), encoding="utf-8")
    Path("out").symlink_to(secret)
    Path("spy.py").symlink_to("../secret/spy.py")
    Path("inside").symlink_to("src")
    git("add", "-A")
    git("commit", "-qm", "links")
    assert gained(capsys, "--git", "HEAD~1..HEAD") == []
    main(["diff", "--git", "HEAD~1..HEAD"])
    out = capsys.readouterr().out
    assert "note: HEAD: the symbolic link out leads out of the sources and is not followed\n" in out
    assert "inside" not in out


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--git", "nowhere"], "there is no commit 'nowhere'"),
        (["--git=--upload-pack=x..HEAD"], "is not a revision"),
        (["--git", "HEAD", "elsewhere"], "elsewhere is in neither HEAD nor the work tree"),
        (["--git", "HEAD", "/"], "is not in the repository"),
        (["--git", "HEAD", "--models", "nowhere"], "exists on neither side"),
        (["one"], "pass two files or folders"),
        (["src", "src/talker.py"], "is a folder"),
    ],
)
def test_wrong_use_is_status_2(arguments: list[str], told: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", *arguments]) == 2
    assert told in capsys.readouterr().err


def test_outside_of_a_repository(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(tmp_path.parent))
    assert main(["diff", "--git", "HEAD"]) == 2
    assert "not a git repository" in capsys.readouterr().err


def test_the_configuration_holds_for_both_sides(capsys: pytest.CaptureFixture[str]) -> None:
    """Its paths are those of the work tree; on each side they mean the files of that side."""
    launch = '<launch><node pkg="a" exec="b" name="{}"/></launch>'
    Path("a.launch.xml").write_text(launch.format("left"), encoding="utf-8")
    git("add", "-A")
    git("commit", "-qm", "launch")
    Path("a.launch.xml").write_text(launch.format("right"), encoding="utf-8")
    Path("rosward.toml").write_text('launch = ["a.launch.xml"]\n[command.diff]\ngit = "HEAD"\n', encoding="utf-8")
    assert main(["diff"]) == 0
    out = capsys.readouterr().out
    assert "nodes gained: 1\n  + /right\nnodes lost: 1\n  - /left\n" in out
    assert "talker" not in out


def test_a_launch_file_that_is_new_starts_nothing_before(capsys: pytest.CaptureFixture[str]) -> None:
    launch = '<launch><node pkg="a" exec="b" name="left"/></launch>'
    Path("a.launch.xml").write_text(launch, encoding="utf-8")
    assert main(["diff", "--git", "HEAD", "--launch", "a.launch.xml"]) == 0
    printed = capsys.readouterr()
    assert "nodes gained: 1\n  + /left\n" in printed.out
    assert "nothing is started on that side" in printed.err


def test_two_folders(capsys: pytest.CaptureFixture[str]) -> None:
    subprocess.run(["cp", "-r", "src", "old"], check=True)
    talker(CHATTER, STATUS)
    assert gained(capsys, "old", "src") == ["/status talker.py:8"]
