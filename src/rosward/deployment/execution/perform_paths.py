# SPDX-License-Identifier: Apache-2.0
"""Substitutions that name files and folders.

$(find-pkg-share demo)/config/a.yaml    ->  Text(hole 'share folder of demo', '/config/a.yaml')
$(dirname)                              ->  Text(hole 'share folder of demo', '/launch')
path-join('/opt', 'a')                  ->  Const('/opt/a')
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from rosward.domain.choice import join, join_all, lift, lift2, reasons_of
from rosward.domain.text import concat, is_path, origins_of, readable
from rosward.domain.unknown import Cause, Reason
from rosward.domain.values import EMPTY, Const, Text, Unknown, Value
from rosward.models.python.std.paths import dirname, join_two, normal

if TYPE_CHECKING:
    from rosward.deployment.execution.scene import Performing, Scene
    from rosward.deployment.tree import Substitution
    from rosward.location import Place


def folder(cause: Cause, package: Value, place: Place) -> Value:
    """The share folder or the install prefix of a package."""

    def one(option: Value) -> Value:
        if isinstance(option, Const) and isinstance(option.value, str):
            return Unknown((Reason(cause, option.value, place),), "str")
        return Unknown(reasons_of(option) or (Reason(cause, readable(option), place),), "str")

    return lift(one, package)


def joined(left: Value, right: Value) -> Value:
    """os.path.join; the folder of a package is an absolute path, though it begins with a hole."""
    return lift2(lambda a, b: b if is_path(b) else join_two(a, b), left, right)


def folder_of(path: Value) -> Value:
    """os.path.dirname of each alternative."""
    return lift(dirname, path)


def normal_path(path: Value) -> Value:
    """The text of `pathlib.Path(path)`."""
    return lift(lambda p: normal(p) if isinstance(p, (Const, Text)) else p, path)


def _share(scene: Scene, substitution: Substitution) -> Value:
    return folder(Cause.SHARE, scene.text(substitution.arguments[0]), substitution.place)


def _prefix(scene: Scene, substitution: Substitution) -> Value:
    return folder(Cause.PREFIX, scene.text(substitution.arguments[0]), substitution.place)


def _executable(scene: Scene, substitution: Substitution) -> Value:
    executable, package = (scene.text(t) for t in substitution.arguments[:2])
    prefix = folder(Cause.PREFIX, package, substitution.place)
    return lift2(lambda p, rest: concat((p, rest)), prefix, _libexec(package, executable))


def _libexec(package: Value, executable: Value) -> Value:
    return lift2(lambda p, e: concat((Const("/lib/"), p, Const("/"), e)), package, executable)


def _on_the_path(scene: Scene, substitution: Substitution) -> Value:
    name = scene.text(substitution.arguments[0])
    somewhere = Unknown((Reason(Cause.ENVIRONMENT, "PATH", substitution.place),), "str")
    return lift(lambda n: concat((somewhere, Const("/"), n)), name)


def _join(scene: Scene, substitution: Substitution) -> Value:
    parts = [scene.text(t) for t in substitution.arguments]
    path = parts[0] if parts else EMPTY
    for part in parts[1:]:
        path = joined(path, part)
    return path


def _current(scene: Scene, substitution: Substitution) -> Value:
    """The path of the current launch file: an include that was executed before changes it, also for those who include."""
    found = [f for f in scene.context.files if f is not None]
    if len(found) < len(scene.context.files):
        scene.fails("there is no current launch file here, so $(dirname) and $(filename) fail", substitution.place)
    if not found:
        return Unknown((Reason(Cause.ERROR, substitution.kind, substitution.place),), "str")
    return join_all(found)


def _filename(scene: Scene, substitution: Substitution) -> Value:
    return _current(scene, substitution)


def _dirname(scene: Scene, substitution: Substitution) -> Value:
    return folder_of(_current(scene, substitution))


def _log_dir(_: Scene, substitution: Substitution) -> Value:
    return Unknown((Reason(Cause.RANDOM, "folder of the log files", substitution.place),), "str")


def _content(scene: Scene, substitution: Substitution) -> Value:
    path = scene.text(substitution.arguments[0])

    def one(option: Value) -> Value:
        file = scene.files.find(option)
        text = scene.files.text(file) if file is not None else None
        if text is not None:
            return Const(text, origins_of(option))
        return Unknown((Reason(Cause.FILE, scene.files.show(option), substitution.place),), "str")

    return lift(one, path)


def _parameter_file(scene: Scene, substitution: Substitution) -> Value:
    path = scene.text(substitution.arguments[0])
    allowed = scene.text(substitution.arguments[1]) if len(substitution.arguments) > 1 else EMPTY
    if isinstance(allowed, Const) and str(allowed.value).lower() in ("", "false", "0", "no", "off"):
        return path
    performed = scene.generated.performed(scene, path, substitution.place)
    known = isinstance(allowed, Const) and str(allowed.value).lower() in ("true", "1", "yes", "on")
    return performed if known else join(path, performed)


PATHS: Final[dict[str, Performing]] = {
    "find-pkg-share": _share,
    "find-pkg-prefix": _prefix,
    "exec-in-pkg": _executable,
    "find-exec": _on_the_path,
    "path-join": _join,
    "filename": _filename,
    "dirname": _dirname,
    "launch-log-dir": _log_dir,
    "file-content": _content,
    "parameter-file": _parameter_file,
}
