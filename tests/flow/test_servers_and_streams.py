# SPDX-License-Identifier: Apache-2.0
"""What comes in and leaves where other libraries wait for it: requests of a web server, streams and programs of asyncio, keys, a shelf."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

from .reported import Said, rows_of, said_by

PROGRAM: Final = """
import asyncio
import curses
import shelve
import threading

import acme
import boto3
import flask
import rclpy
from flask import Flask, request
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.last = ''
        self.out = self.create_publisher(String, '/out', 10)
        self.create_subscription(String, '/in', self.on_in, 10)
        self.create_timer(1.0, self.tick)
        self.app = Flask(__name__)

    def on_in(self, msg):
        self.last = msg.data

    def say(self, text):
        self.out.publish(String(data=text))

    def tick(self):
        pass

{}


async def stay(robot):
    await robot.run()


rclpy.init()
robot = Robot()
threading.Thread(target=rclpy.spin, args=(robot,)).start()
{}
"""
FLASK: Final = "robot.app.add_url_rule('/say/<word>', view_func=robot.answer)\nrobot.app.run()"
SOURCES: Final = {
    "request": ("network", "    def answer(self):\n        self.say(request.json['text'])", FLASK),
    "request of the module": (
        "network",
        "    def answer(self):\n        self.say(flask.request.args.get('q', ''))",
        FLASK,
    ),
    "request, its path": ("network", "    def answer(self, word):\n        self.say(word)", FLASK),
    "stream": (
        "network",
        "    async def run(self):\n        reader, _ = await asyncio.open_connection('acme', 80)\n"
        "        line = await reader.readline()\n        self.say(line.decode())",
        "asyncio.run(stay(robot))",
    ),
    "stream of a server": (
        "network",
        "    async def run(self):\n        await asyncio.start_server(self.serve, '', 80)\n\n"
        "    async def serve(self, reader, writer):\n        self.say((await reader.read(9)).decode())",
        "asyncio.run(stay(robot))",
    ),
    "program": (
        "process",
        "    async def run(self):\n        program = await asyncio.create_subprocess_exec('date')\n"
        "        said, _ = await program.communicate()\n        self.say(said.decode())",
        "asyncio.run(stay(robot))",
    ),
    "key": ("stdin", "    def run(self, window):\n        self.say(window.getkey())", "curses.wrapper(robot.run)"),
    "key of a screen": ("stdin", "    def run(self):\n        self.say(curses.initscr().getkey())", "robot.run()"),
    "shelf": ("file", "    def run(self):\n        self.say(shelve.open('shelf')['word'])", "robot.run()"),
}
SINKS: Final = {
    "stream": (
        "network",
        "    async def run(self):\n        _, writer = await asyncio.open_connection('acme', 80)\n"
        "        writer.write(self.last.encode())",
        "asyncio.run(stay(robot))",
    ),
    "program": (
        "process",
        "    async def run(self):\n        await asyncio.create_subprocess_shell(self.last)",
        "asyncio.run(stay(robot))",
    ),
    "answer": ("network", "    def answer(self):\n        return flask.jsonify(word=self.last)", FLASK),
    "shelf": (
        "file",
        "    def tick(self):\n        with shelve.open('shelf') as shelf:\n            shelf['word'] = self.last",
        "",
    ),
}


def _said(folder: Path, sink: str, methods: str, start: str) -> Said:
    return said_by(folder, PROGRAM.format(methods, start), sink)


@pytest.mark.parametrize("case", SOURCES)
def test_comes_in(tmp_path: Path, case: str) -> None:
    kind, methods, start = SOURCES[case]
    assert kind in _said(tmp_path, "topic:/out", methods, start).data


@pytest.mark.parametrize("case", SINKS)
def test_leaves(tmp_path: Path, case: str) -> None:
    kind, methods, start = SINKS[case]
    assert "topic:/in" in _said(tmp_path, kind, methods, start).data


def test_what_an_unknown_library_gives_later_is_one_object(tmp_path: Path) -> None:
    methods = (
        "    async def run(self):\n        line = await acme.connect()\n        line.put(self.last)\n"
        "        self.say(await line.get())"
    )
    assert "topic:/in" in _said(tmp_path, "topic:/out", methods, "asyncio.run(stay(robot))").data


def test_an_index_is_no_call(tmp_path: Path) -> None:
    """Each function of the library sends something; what it has given is only read."""
    methods = "    def tick(self):\n        found = boto3.client('s3').list_buckets()\n        self.say(found['Buckets'][0]['Name'])"
    rows = rows_of(tmp_path, PROGRAM.format(methods, ""))
    assert len({row.line for row in rows if row.sink == "network"}) == 1
