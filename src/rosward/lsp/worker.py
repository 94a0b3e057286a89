# SPDX-License-Identifier: Apache-2.0
"""A process of its own that analyses one workspace again and again, as the server asks it to: lines of JSON in, lines of JSON out.

    {"renew": 7, "texts": {"/ws/talker.py": "…"}, "changed": ["/ws/talker.py"]}     texts of closed files are null
    {"view": […], "of": 7}   {"done": 7, "names": […]}   {"log": "…"}

A newer question ends the work on an older one. It ends with its input; nothing that it reads is executed.
"""

from __future__ import annotations

import json
import os
import sys
import threading
from collections.abc import Iterable
from typing import IO, Any, Final, final

from rosward.guard import where
from rosward.lsp.records import View, written
from rosward.lsp.session import Session

__all__ = ["Worker", "serve"]


class _StaleError(BaseException):
    """A newer question has come. No fault, so that nothing on the way takes it for one."""


@final
class Worker:
    """Answers questions in the order in which they come, and only the newest of those that wait."""

    def __init__(self, session: Session, output: IO[str]) -> None:
        self._session = session
        self._output = output
        self._texts: dict[str, bytes] = {}
        self._changed: set[str] | None = None
        self._lock: Final = threading.Condition()
        self._wanted: dict[str, Any] | None = None
        self._ended = False
        self._newest = 0

    def listen(self, lines: Iterable[str]) -> None:
        """Take questions until there are no more; what is no question is left out."""
        for line in lines:
            try:
                question = json.loads(line)
                number = int(question["renew"])
            except (ValueError, KeyError, TypeError):
                continue
            with self._lock:
                older, self._wanted = self._wanted, question
                if older is not None:
                    question["texts"] = {**older.get("texts", {}), **question.get("texts", {})}
                    before, now = older.get("changed"), question.get("changed")
                    question["changed"] = None if before is None or now is None else [*before, *now]
                self._newest = number
                self._lock.notify()
        with self._lock:
            self._ended = True
            self._lock.notify()

    def work(self) -> None:
        """Answer until there are no more questions."""
        self._changed = set()
        while True:
            with self._lock:
                while self._wanted is None and not self._ended:
                    self._lock.wait()
                question, self._wanted = self._wanted, None
            if question is None:
                return
            self._answer(question)

    def _answer(self, question: dict[str, Any]) -> None:
        number = int(question["renew"])
        for path, text in question.get("texts", {}).items():
            if text is None:
                self._texts.pop(path, None)
            else:
                self._texts[path] = str(text).encode("utf-8", "surrogatepass")
        changed = question.get("changed")
        self._changed = None if changed is None or self._changed is None else {*self._changed, *changed}

        def progress(what: str, _done: int, _all: int) -> None:
            if self._newest != number:
                raise _StaleError
            if ": " in what:
                self._say({"log": what})

        def tell(view: View) -> None:
            self._write(f'{{"of":{number},"view":{written(view)}}}')

        try:
            names = self._session.renew(dict(self._texts), self._changed, tell, progress)
        except _StaleError:
            return  # what has changed is kept in mind for the next question
        except Exception as error:
            self._say({"log": f"internal error ({type(error).__name__} in {where(error)}); please report this"})
            names = None
        self._changed = set()
        self._say({"done": number, "names": names, "ran": self._session.memory.ran, "kept": len(self._session.memory)})

    def _say(self, document: dict[str, Any]) -> None:
        self._write(json.dumps(document))

    def _write(self, line: str) -> None:
        try:
            self._output.write(f"{line}\n")
            self._output.flush()
        except (OSError, ValueError):  # the server has gone
            os._exit(0)


def serve(session: Session) -> None:
    """Work for the process that holds the other ends of our standard input and output."""
    output = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)  # what is printed by mistake is no answer
    worker = Worker(session, output)
    threading.Thread(target=_until_the_end, args=(worker,), daemon=True).start()
    worker.work()


def _until_the_end(worker: Worker) -> None:
    worker.listen(sys.stdin)
    os._exit(0)  # also in the middle of an analysis
