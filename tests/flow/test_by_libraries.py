# SPDX-License-Identifier: Apache-2.0
"""Promise: what goes through a library, or stands where nobody looks for it, is not lost. The rows are read as in `test_flows.py`."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pytest

from .robots import Case, said_strongly

CASES: Final = {
    "JSON that is written to text in memory": Case(
        "self.value = ''",
        "import io, json\nf = io.StringIO()\njson.dump({'a': msg.data}, f)\nself.value = f.getvalue()",
        "float(self.value)",
    ),
    "a row of CSV that is written to text in memory": Case(
        "self.value = ''",
        "import csv, io\nf = io.StringIO()\ncsv.writer(f).writerow([msg.data])\nself.value = f.getvalue()",
        "float(self.value)",
    ),
    "what is printed prettily to text in memory": Case(
        "self.value = ''",
        "import io, pprint\nf = io.StringIO()\npprint.pprint(msg.data, stream=f)\nself.value = f.getvalue()",
        "float(self.value)",
    ),
    "a digest that is updated": Case(
        "self.value = ''",
        "import hashlib\nh = hashlib.sha256()\nh.update(str(msg.data).encode())\nself.value = h.hexdigest()",
        "float(ord(self.value[0]))",
    ),
    "what a handler of the program logs": Case(
        "self.value = []",
        "import logging\nclass H(logging.Handler):\n    def emit(s, record):\n        self.value.append(record.getMessage())\n"
        "log = logging.getLogger('x')\nlog.addHandler(H())\nlog.warning('%s', msg.data)",
        "float(self.value[0])",
    ),
    "the attribute of a function": Case("", "remembered.last = msg.data", "remembered.last"),
    "the attribute of a function, by its name": Case(
        "", "setattr(remembered, 'last', msg.data)", "getattr(remembered, 'last')"
    ),
    "the attribute of a function, in its dict": Case("", "remembered.__dict__['last'] = msg.data", "remembered.last"),
    "the attribute of a function that a decorator sets": Case(
        "self.value = 0.0",
        "def marked(f):\n    f.x = msg.data\n    return f\n@marked\ndef g():\n    pass\nself.value = g.x",
        "self.value",
    ),
    "a variable among all of them": Case("self.value = 0.0", "x = msg.data\nself.value = locals()['x']", "self.value"),
    "a variable among all of them, by vars": Case(
        "self.value = 0.0", "x = msg.data\nself.value = vars()['x']", "self.value"
    ),
}


@pytest.mark.parametrize("case", CASES.values(), ids=list(CASES))
def test_what_goes_through_a_library_is_not_lost(case: Case, tmp_path: Path) -> None:
    sources, said = said_strongly(case, tmp_path)
    assert "topic:/in" in sources, said
