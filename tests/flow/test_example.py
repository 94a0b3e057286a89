# SPDX-License-Identifier: Apache-2.0
"""Promise: the rules of the example hold, and a leak in a copy of it is found, with the lines by which the picture leaves."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from rosward.cli import main

ROOT = Path(__file__).parents[2]
_DETECTOR = Path("delivery_perception/delivery_perception/dock_detector.py")
_LEAK = {
    "        self._looking = False\n        self._pose =": (
        "        self._looking = False\n"
        "        self._last = None\n"
        "        self._preview = self.create_publisher(Image, '/fleet/preview', 1)\n"
        "        self.create_timer(1.0, self._show)\n"
        "        self._pose ="
    ),
    "    def _on_picture(self, image, info):\n": (
        "    def _show(self):\n"
        "        if self._last is not None:\n"
        "            self._preview.publish(Image(data=self._last))\n"
        "\n"
        "    def _on_picture(self, image, info):\n"
        "        self._last = image.data\n"
    ),
}


@pytest.mark.usefixtures("remembered")
def test_the_rules_hold(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["flow", str(ROOT / "examples" / "delivery_robot"), "--check"]) == 0
    assert capsys.readouterr().out == "No forbidden flow found.\n"


def test_a_leak_is_found(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "robot"
    shutil.copytree(ROOT / "examples" / "delivery_robot", folder)
    text = (folder / _DETECTOR).read_text()
    for old, new in _LEAK.items():
        assert text.count(old) == 1
        text = text.replace(old, new)
    (folder / _DETECTOR).write_text(text)
    lines = text.splitlines()
    kept = 1 + next(n for n, line in enumerate(lines) if "self._last = image.data" in line)
    sent = 1 + next(n for n, line in enumerate(lines) if "self._preview.publish" in line)

    assert main(["flow", str(folder), "--check"]) == 1
    said = capsys.readouterr().out.splitlines()
    (broken,) = [number for number, line in enumerate(said) if " RW601 " in line]
    assert said[broken] == (
        "error   RW601 /porter/camera/image_raw reaches /fleet/preview through /porter/dock_detector, "
        "which 'camera pictures stay on the robot' forbids"
    )
    path = [line.strip().rpartition(":")[2] for line in said[broken + 1 : -1]]
    assert path == [str(kept - 1), str(kept), str(sent - 1), str(sent)]
