# SPDX-License-Identifier: Apache-2.0
"""A workspace that is written in a test, analysed in this process, and asked as an editor asks."""

from __future__ import annotations

from pathlib import Path
from typing import final

from rosward.lsp.records import View
from rosward.lsp.session import Session, Settings
from rosward.lsp.state import Folder, State

SETUP = """from setuptools import setup
setup(name="demo", packages=["demo"], data_files=[("share/demo/launch", {launch}), ("share/demo/config", {config})],
      entry_points={{"console_scripts": [{scripts}]}})
"""
TALKER = """import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.rate = self.declare_parameter("rate", 5).value
        self.pub = self.create_publisher(String, "chatter", 10)

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
LISTENER = """import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Listener(Node):
    def __init__(self):
        super().__init__("listener")
        self.create_subscription(String, "chatter", self.on_text, 10)

    def on_text(self, text):
        pass

def main():
    rclpy.init()
    rclpy.spin(Listener())
"""
LAUNCH = """<launch>
  <node pkg="demo" exec="talker">
    <param from="$(find-pkg-share demo)/config/demo.yaml"/>
    <remap from="chatter" to="/news"/>
  </node>
  <node pkg="demo" exec="listener">
    <remap from="chatter" to="/news"/>
  </node>
</launch>
"""
PARAMETERS = """/**:
  ros__parameters:
    rate: 7
"""
DEMO = {
    "demo/talker.py": TALKER,
    "demo/listener.py": LISTENER,
    "launch/demo.launch.xml": LAUNCH,
    "config/demo.yaml": PARAMETERS,
}


def write(root: Path, files: dict[str, str]) -> Path:
    """A package `demo` with these files; each module below `demo/` that has a `main` is an executable."""
    listed = {part: [name for name in files if name.startswith(f"{part}/")] for part in ("launch", "config")}
    programs = [Path(name).stem for name, text in files.items() if name.startswith("demo/") and "def main" in text]
    scripts = ", ".join(f'"{name} = demo.{name}:main"' for name in programs)
    texts = {
        "package.xml": "<package format='3'><name>demo</name><version>1.0.0</version><description>d</description>"
        "<maintainer email='a@b.c'>a</maintainer><license>x</license><depend>rclpy</depend>"
        "<export><build_type>ament_python</build_type></export></package>\n",
        "setup.py": SETUP.format(scripts=scripts, **listed),
        "demo/__init__.py": "",
        **files,
    }
    for name, text in texts.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
    return root


@final
class Desk:
    """The state of a server, without a server."""

    def __init__(self, root: Path, files: dict[str, str] | None = None) -> None:
        self.root = write(root, DEMO if files is None else files) if files != {} else root
        self.state = State()
        self.folder: Folder = self.state.add_folder(str(root))
        self.session = Session(Settings(str(root)))
        self.told: list[str] = []

    def path(self, name: str) -> str:
        return str(self.root / name)

    def open(self, name: str, text: str | None = None) -> None:
        """Open a file, or type another text into it."""
        self.state.open(self.path(name), (self.root / name).read_text() if text is None else text)

    def renew(self, *changed: str, everything: bool = False) -> list[str]:
        """Analyse what has changed; the names of the views that came."""
        texts = {path: document.text for path, document in self.state.documents.items()}
        self.told = []

        def tell(view: View) -> None:
            self.told.append(view.name)
            self.folder.take(view, texts)

        shown = {path: text.encode() for path, text in texts.items()}
        paths = None if everything else [self.path(name) for name in changed]
        names = self.session.renew(shown, paths, tell, lambda *_: None)
        self.folder.keep_only(names)
        return self.told

    def at(self, name: str, text: str, nth: int = 0) -> tuple[str, int, int]:
        """The position in the middle of a text: path, line and column from 0."""
        lines = self.state.lines(self.path(name))
        found = [(i, line.index(text)) for i, line in enumerate(lines) if text in line]
        line, column = found[nth]
        return self.path(name), line, column + len(text) // 2
