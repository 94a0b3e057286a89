# SPDX-License-Identifier: Apache-2.0
"""Promise: build descriptions are read without running them; what cannot be told is a finding with its line."""

from __future__ import annotations

from pathlib import Path

import pytest

from rosward.source.entry_points import PythonSide, parse_entry_point, read_pyproject, read_setup_cfg
from rosward.source.setup_py import read_setup_py
from source.trees import codes, manifest, names, read


def described(tmp_path: Path, text: str | bytes) -> PythonSide:
    (tmp_path / "setup.py").write_bytes(text.encode() if isinstance(text, str) else text)
    return read_setup_py(str(tmp_path / "setup.py"), "setup.py")


def commands(declared: PythonSide) -> list[str]:
    return [f"{e.name} = {e.module}:{e.function} @{e.place.line}" for e in declared.entry_points]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("talker = demo.talker:main", ("talker", "demo.talker", "main")),
        ("  a-b.py=x:y  ", ("a-b.py", "x", "y")),
        ("a = x.y : C.run [extra]", ("a", "x.y", "C.run")),
        ("a = x.1_y:main", ("a", "x.1_y", "main")),
        ("a = räder:start", ("a", "räder", "start")),
        ("a = x", None),
        ("a = x:", None),
        ("= x:y", None),
        ("x:y", None),
        ("a = x/y:z", None),
        ("a = x:y()", None),
        ("", None),
        ("a" * 5000 + " = x:y", None),
    ],
)
def test_entry_points(text: str, expected: tuple[str, str, str] | None) -> None:
    assert parse_entry_point(text) == expected


@pytest.mark.parametrize(
    ("script", "expected"),
    [
        ("setup(entry_points={'console_scripts': ['a = m.a:main',\n 'b = m.b:main']})",
         ["a = m.a:main @1", "b = m.b:main @2"]),
        ("n = 'm'\nsetup(entry_points={'console_scripts': ['a = ' + n + '.a:main']})", ["a = m.a:main @2"]),
        ("n = 'm'\nsetup(entry_points={'console_scripts': [f'a = {n}.a:main']})", ["a = m.a:main @2"]),
        ("setup(entry_points={'console_scripts': ['a = %s.a:main' % 'm']})", ["a = m.a:main @1"]),
        ("setup(entry_points={'console_scripts': ['a = {}.a:main'.format('m')]})", ["a = m.a:main @1"]),
        ("setup(entry_points={'console_scripts': ['{0} = m.{0}:main'.format(x) for x in ('a', 'b')]})",
         ["a = m.a:main @1", "b = m.b:main @1"]),
        ("setup(entry_points={'console_scripts': [*['a = m.a:main'], *('b = m.b:main',)]})",
         ["a = m.a:main @1", "b = m.b:main @1"]),
        ("s = []\nfor x in ['a', 'b']:\n  s.append(f'{x} = m.{x}:main')\nsetup(entry_points={'console_scripts': s})",
         ["a = m.a:main @4", "b = m.b:main @4"]),
        ("s = ['a = m.a:main']\ns += ['b = m.b:main']\nsetup(entry_points=dict(console_scripts=s))",
         ["a = m.a:main @1", "b = m.b:main @2"]),
        ("setup(entry_points='''\n[console_scripts]\na = m.a:main\n# no\n[other]\nb = m.b:main\n''')",
         ["a = m.a:main @1"]),
        ("setup(entry_points={'console_scripts': 'a = m.a:main'})", ["a = m.a:main @1"]),
        ("k = {}\nk['entry_points'] = {'console_scripts': ['a = m.a:main']}\nsetup(**k)", ["a = m.a:main @2"]),
        ("import setuptools\nif True:\n  setuptools.setup(entry_points={'gui_scripts': ['a = m.a:main']})",
         ["a = m.a:main @3"]),
        ("def go():\n  setup(entry_points={'console_scripts': ['a = m.a:main']})\ngo()", ["a = m.a:main @2"]),
        ("d = {'x': ['a']}\ns = [v + ' = m:f' for vs in d.values() for v in vs if v != 'b']\n"
         "setup(entry_points={'console_scripts': s})",
         ["a = m:f @3"]),
        ("setup(name='x')", []),
        ("setup(entry_points=None)", []),
        ("setup(entry_points={})", []),
        ("", []),
    ],
)  # fmt: skip
def test_usual_forms_of_setup_py(tmp_path: Path, script: str, expected: list[str]) -> None:
    declared = described(tmp_path, script)
    assert commands(declared) == expected
    assert declared.findings == ()


def test_name_folders_and_scripts_of_setup_py(tmp_path: Path) -> None:
    declared = described(
        tmp_path, "n = 'demo'\nsetup(name=n, package_dir={'': 'src', n: 'x'},\n scripts=[\n'bin/' + n, 'b.py'])"
    )
    assert (declared.name, declared.package_dir) == ("demo", (("", "src"), ("demo", "x")))
    assert [script for script, _ in declared.scripts] == ["bin/demo", "b.py"]


@pytest.mark.parametrize(
    ("script", "line"),
    [
        ("setup(\nentry_points=make())", 2),
        ("setup(entry_points={'console_scripts':\n find()})", 1),
        ("setup(entry_points={'console_scripts': ['a = m.a:main', find()]})", 1),
        ("setup(entry_points={'console_scripts': ['a = m.a:main', 'nonsense']})", 1),
        ("setup(scripts=find('scripts/*'))", 1),
        ("setup(**options)", 1),
        ("x = 1\nsetup(entry_points={'console_scripts': [f'{i} = m:{i}' for i in range(9)]})", 2),
        ("setup(", 1),
        ("print 'x'", 1),
        ("x = " + "(" * 3000, 0),
        ("x = " + "-" * 100_000 + "1", 0),
        (b"x = '\0'", 1),
    ],
)
def test_what_cannot_be_told_is_a_finding(tmp_path: Path, script: str | bytes, line: int) -> None:
    findings = described(tmp_path, script).findings
    assert findings
    assert {f.code for f in findings} == {"RW008"}
    assert line in {0, findings[0].place.line} or line == findings[0].place.line


def test_what_can_be_told_beside_it_is_kept(tmp_path: Path) -> None:
    declared = described(tmp_path, "setup(entry_points={'console_scripts': ['a = m.a:main', find()] + more()})")
    assert commands(declared) == ["a = m.a:main @1"]
    assert declared.findings


@pytest.mark.parametrize(
    "script",
    [
        "x = 'a'\n" + "x = x + x\n" * 100 + "setup(name=x)",
        "x = ['a']\n" + "x = x + x\n" * 100 + "setup(scripts=x)",
        "a = ['x'] * 10\nb = "
        + repr(["x"] * 5000)
        + "\nsetup(scripts=[p + q for p in b for q in b for r in b if p != q])",
        "b = " + repr(["x"] * 5000) + "\nfor i in b:\n for j in b:\n  for k in b:\n   x = 1\nsetup(name='x')",
        "setup(name='%1000000000d' % 1, scripts=['{:>999999999}'.format('x')])",
        "x = 'a' * 10**9\nsetup(name=x)",
        "x = 'a' + 'b' * 99\n" + "y = '{0}' * 99\n" + "setup(name='{0}{0}{0}'.format(x), scripts=[x.replace('a', x)] )",
        "x = []\nx.append(x)\nsetup(scripts=x)",
        "d = {}\nd['a'] = d\nsetup(**d)",
        "x = [[]]\nfor i in " + repr(list(range(500))) + ":\n x = [x, x]\nsetup(name='%s' % x, scripts=[x])",
        "setup(name=10**10**10)",
        "def setup(): setup()\nsetup()",
    ],
)
def test_setup_py_that_would_not_end(tmp_path: Path, script: str) -> None:
    described(tmp_path, script)


def test_nothing_is_executed(tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    described(tmp_path, f"open({str(mark)!r}, 'w')\n__import__('os').mkdir({str(mark)!r})\nsetup(name='x')")
    assert not mark.exists()


def test_setup_cfg(tmp_path: Path) -> None:
    path = tmp_path / "setup.cfg"
    path.write_text(
        "[metadata]\nname = demo\n[options]\npackage_dir =\n  =src\nscripts =\n  bin/x\n"
        "[options.entry_points]\nconsole_scripts =\n  # none\n  a = m.a:main\n  b=m.b:main\n"
    )
    declared = read_setup_cfg(str(path), "setup.cfg")
    assert commands(declared) == ["a = m.a:main @11", "b = m.b:main @12"]
    assert (declared.name, declared.package_dir, declared.scripts[0][0]) == ("demo", (("", "src"),), "bin/x")
    assert declared.findings == ()


@pytest.mark.parametrize("text", ["nonsense", "[a\n", "[a]\n=\n b\n[", "é".encode("latin-1"), b"\0\0"])
def test_broken_setup_cfg(tmp_path: Path, text: str | bytes) -> None:
    path = tmp_path / "setup.cfg"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    assert [f.code for f in read_setup_cfg(str(path), "setup.cfg").findings] == ["RW008"]


def test_percent_signs_in_setup_cfg(tmp_path: Path) -> None:
    path = tmp_path / "setup.cfg"
    path.write_text("[develop]\nscript_dir=$base/lib/%(x)s\n[options.entry_points]\nconsole_scripts=a = m:f\n")
    assert commands(read_setup_cfg(str(path), "setup.cfg")) == ["a = m:f @4"]


def test_pyproject(tmp_path: Path) -> None:
    path = tmp_path / "pyproject.toml"
    path.write_text(
        '[project]\nname = "demo"\n[project.scripts]\na = "m.a:main"\n"b-c" = "m.b:main"\n'
        '[tool.poetry.scripts]\nd = {reference = "m.d:main", type = "console"}\n'
        '[tool.setuptools]\npackage-dir = {"" = "src"}\nscript-files = ["bin/x"]\n'
    )
    declared = read_pyproject(str(path), "pyproject.toml")
    assert commands(declared) == ["a = m.a:main @4", "b-c = m.b:main @5", "d = m.d:main @7"]
    assert (declared.name, declared.package_dir, declared.scripts[0][0]) == ("demo", (("", "src"),), "bin/x")


def test_what_catkin_pkg_adds_is_no_executable(tmp_path: Path) -> None:
    script = (
        "from catkin_pkg.python_setup import generate_distutils_setup\n"
        "d = generate_distutils_setup(packages=['demo'], scripts=['bin/x'])\nsetup(**d)"
    )
    found = described(tmp_path, script)
    assert not found.findings
    assert [name for name, _ in found.scripts] == ["bin/x"]


@pytest.mark.parametrize(
    "text", ["[project\n", "x = 1\nx = 2\n", "a = " + "[" * 50_000, "a" * 10 + "\0", "project = 1\ntool = []\n"]
)
def test_broken_pyproject(tmp_path: Path, text: str) -> None:
    path = tmp_path / "pyproject.toml"
    path.write_text(text)
    findings = read_pyproject(str(path), "pyproject.toml").findings
    assert {f.code for f in findings} <= {"RW008"}
    assert findings or text.startswith("project")


def test_three_descriptions_together_give_each_command_once(tmp_path: Path) -> None:
    found = read(
        tmp_path,
        {
            "package.xml": manifest("demo"),
            "setup.py": "from setuptools import setup\nsetup(entry_points={'console_scripts': ['a = demo.a:main']})",
            "setup.cfg": "[options.entry_points]\nconsole_scripts =\n  a = demo.a:main\n  b = demo.b:main\n",
            "pyproject.toml": '[project.scripts]\nc = "demo.c:main"\n',
            **dict.fromkeys(["demo/__init__.py", "demo/a.py", "demo/b.py", "demo/c.py"], ""),
        },
    )
    assert [e.name for e in found.executables] == ["a", "b", "c"]
    assert found.findings == ()


BROKEN = {
    "not well-formed": "<package><name>demo</name>",
    "empty": "",
    "no XML": "name: demo",
    "unknown format": manifest("demo").replace('format="3"', 'format="99"'),
    "format is not a number": manifest("demo").replace('format="3"', 'format="x"'),
    "no maintainer": manifest("demo").replace('<maintainer email="a@b.org">a</maintainer>', ""),
    "two build types": manifest("demo").replace("<export>", "<export><build_type>x</build_type>"),
    "bad condition": manifest("demo", extra='<depend condition="((">x</depend>'),
    "condition of a thousand brackets": manifest("demo", extra=f'<depend condition="{"(" * 1000}">x</depend>'),
    "deep": manifest("demo", extra="<a>" * 10_000),
    "unknown encoding": "<?xml version='1.0' encoding='klingon'?>" + manifest("demo").partition("\n")[2],
    "two packages": manifest("demo") + manifest("other").partition("\n")[2],
    "external entity": '<!DOCTYPE p [<!ENTITY x SYSTEM "file:///etc/passwd">]>' + manifest("&x;").partition("\n")[2],
    "external definition": '<!DOCTYPE p SYSTEM "http://127.0.0.1:9/x.dtd">' + manifest("demo").partition("\n")[2],
    "billion laughs": "<!DOCTYPE p ["
    + "".join(f'<!ENTITY a{i} "{f"&a{i - 1};" * 10 if i else "ha"}">' for i in range(30))
    + "]>"
    + manifest("&a29;").partition("\n")[2],
}


@pytest.mark.parametrize("what", list(BROKEN))
def test_a_package_xml_that_cannot_be_read_is_told_and_its_files_are_kept(tmp_path: Path, what: str) -> None:
    found = read(tmp_path, {"demo/package.xml": BROKEN[what], "demo/a.py": ""})
    assert [code for code, _ in codes(found)] == ["RW017"]
    assert codes(found)[0][1].startswith("demo/package.xml")
    assert [package.name for package in found.packages] == ["demo"]
    assert names(found) == ["demo/a.py"]


def test_the_name_in_a_rejected_manifest_is_kept(tmp_path: Path) -> None:
    text = manifest("real_name", extra="<depend>a</depend><exec_depend>a</exec_depend>")
    found = read(tmp_path, {"folder/package.xml": text})
    assert [(p.name, p.build_type) for p in found.packages] == [("real_name", "ament_python")]
    assert "reject" in found.findings[0].message
    assert "redundant" in found.findings[0].message


def test_a_utf16_doctype_is_seen_too(tmp_path: Path) -> None:
    text = '<?xml version="1.0" encoding="utf-16"?>' + BROKEN["external entity"]
    found = read(tmp_path, {"demo/package.xml": text.encode("utf-16")})
    assert "document type" in found.findings[0].message
