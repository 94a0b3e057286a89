# SPDX-License-Identifier: Apache-2.0
"""In which state is the content of a repository?

    state_of("/checkouts/demo")    "9f86d081884c7d65…", another one after any file came, went or was written

Of each file its name, kind, size and times count, not its bytes: recordings and meshes are large, and nothing is opened. Links are not followed,
as the analysis follows none that leads out. What is in `.git` is no source.
"""

from __future__ import annotations

import hashlib
import os
import stat
from typing import Final

__all__ = ["state_of"]

_HISTORY: Final = frozenset({b".git", b".hg", b".svn"})


def state_of(path: str) -> str:
    """A digest of the state. Raises OSError where the folder itself cannot be listed, ValueError where no path can be so."""
    digest = hashlib.sha256()
    root = os.fsencode(path)
    with os.scandir(root):
        pass
    waiting = [root]
    while waiting:
        folder = waiting.pop()
        try:
            with os.scandir(folder) as found:
                entries = sorted(found, key=lambda entry: entry.name)
        except OSError as error:
            digest.update(b"%b\0unread %d\0" % (folder[len(root) :], error.errno or 0))
            continue
        for entry in entries:
            try:
                about = entry.stat(follow_symlinks=False)
            except OSError:  # it went meanwhile
                continue
            name = entry.path[len(root) :]
            if stat.S_ISDIR(about.st_mode):
                digest.update(b"%b\0folder %d\0" % (name, about.st_mode))
                if entry.name not in _HISTORY:
                    waiting.append(entry.path)
            else:
                told = (about.st_mode, about.st_size, about.st_mtime_ns, about.st_ctime_ns)
                digest.update(b"%b\0%d %d %d %d\0" % (name, *told))
    return digest.hexdigest()
