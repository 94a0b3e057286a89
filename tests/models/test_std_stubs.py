# SPDX-License-Identifier: Apache-2.0
"""What the bodies of the stubs of the standard library do, run as plain Python."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from models.concrete_stubs import STUBS, Default, Stubs

SPDX = "# SPDX-License-Identifier: Apache-2.0\n"
OURS = sorted(p.relative_to(STUBS).as_posix() for p in STUBS.rglob("*.pyi"))


@pytest.mark.parametrize("name", OURS)
def test_each_stub_names_its_licence(name: str) -> None:
    assert (STUBS / name).read_text(encoding="utf-8").startswith(SPDX)


def parser(stubs: Stubs) -> Any:
    return stubs.load("argparse").ArgumentParser(description="demo")


@pytest.fixture
def stubs() -> Stubs:
    return Stubs(_exact=lambda *_: None, _is_typed=lambda *_: True)


def shown(namespace: object) -> dict[str, str]:
    return {k: repr(v) for k, v in vars(namespace).items()}


def test_arguments_are_defaults_or_unknown(stubs: Stubs) -> None:
    made = parser(stubs)
    made.add_argument("-t", "--topic-name", default="/scan")
    made.add_argument("--rate", type=float, default="2")
    made.add_argument("--name", required=True)
    made.add_argument("--optional")
    made.add_argument("--verbose", action="store_true")
    made.add_argument("--quiet", action="store_false", dest="loud")
    made.add_argument("--mode", choices=["a", "b"], required=True)
    made.add_argument("--more", nargs="+", required=True)
    made.add_argument("--level", action="store_const", const=3)
    made.add_argument("robot")
    made.add_argument("where", nargs="?", default="/here")
    assert shown(made.parse_args()) == {
        "topic_name": "default --topic-name='/scan'",
        "rate": "default --rate=2.0",
        "name": "'?--name'",
        "optional": "None or '?--optional'",
        "verbose": "default --verbose=False",
        "loud": "default --quiet=True",
        "mode": "'a' or 'b'",
        "more": "['?--more']",
        "level": "None or 3",
        "robot": "'?robot'",
        "where": "default where='/here'",
    }


def test_groups_parents_and_sub_parsers(stubs: Stubs) -> None:
    base = parser(stubs)
    base.add_argument_group("g").add_argument("--a", default=1)
    made = stubs.load("argparse").ArgumentParser(parents=[base])
    made.add_mutually_exclusive_group(required=True).add_argument("--b", default=2)
    sub = made.add_subparsers(dest="command", required=True)
    one, two = sub.add_parser("one"), sub.add_parser("two", help="x")
    one.set_defaults(run="f")
    two.set_defaults(run="g")
    two.add_argument("--c", default=3)
    made.set_defaults(b=5)
    namespace, rest = made.parse_known_args()
    assert shown(namespace) == {
        "a": "default --a=1",
        "b": "default --b=5",
        "command": "'one' or 'two'",
        "run": "'f' or 'g'",
        "c": "default --c=3",
    }
    assert rest == "?sys.argv"


def test_known_arguments_are_exact() -> None:
    stubs = Stubs(_exact=lambda *_: ({"topic": "/points"}, ["left"]))
    made = parser(stubs)
    made.add_argument("--topic", default="/scan")
    made.add_argument("--rate", type=int, default="3")
    made.add_argument("--fast", action="store_true")
    namespace, rest = made.parse_known_args(["--topic", "/points", "left"])
    assert vars(namespace) == {"topic": "/points", "rate": 3, "fast": False}
    assert rest == ["left"]


def test_options_of_optparse_and_click(stubs: Stubs) -> None:
    old = stubs.load("optparse").OptionParser(usage="x")
    old.add_option("-n", "--name", dest="name", default="bob", help="x")
    old.add_option("-v", action="store_true", dest="verbose")
    assert shown(old.parse_args()[0]) == {"name": "default --name='bob'", "verbose": "default -v=False"}
    click = stubs.load("click")
    seen: list[dict[str, object]] = []

    @click.command()  # type: ignore[untyped-decorator]
    @click.option("--topic", default="/scan")  # type: ignore[untyped-decorator]
    @click.option("--fast", is_flag=True)  # type: ignore[untyped-decorator]
    @click.argument("robot")  # type: ignore[untyped-decorator]
    def main(**keywords: object) -> None:
        seen.append(keywords)

    main()
    assert {k: repr(v) for k, v in seen[0].items()} == {
        "topic": "default --topic='/scan'",
        "fast": "default --fast=False",
        "robot": "'?robot'",
    }


def test_environment(stubs: Stubs) -> None:
    os = stubs.load("os")
    found = os.getenv("TOPIC", "/scan")
    assert isinstance(found, Default)
    assert (found.name, found.value) == ("TOPIC", "/scan")
    assert repr(os.environ.get("TOPIC")) == "None or '?TOPIC'"
    assert os.environ["HOME"] == "?HOME"
    os.environ["TOPIC"] = "/set"
    assert os.environ.get("TOPIC", "/scan") == os.environ["TOPIC"] == "/set"
    assert "TOPIC" in os.environ


def test_collections(stubs: Stubs) -> None:
    collections = stubs.load("collections")
    queue = collections.deque([1, 2, 3], maxlen=2)
    queue.append(4)
    assert list(queue) == [3, 4]
    assert queue.popleft() == 3
    groups = collections.defaultdict(list)
    groups["a"].append(1)
    assert dict(groups.items()) == {"a": [1]}
    assert len(collections.Counter("aab")) == 2
    chain = collections.ChainMap({"a": 1}, {"a": 2, "b": 3})
    assert (chain["a"], chain["b"]) == (1, 3)


def test_paths() -> None:
    stubs = Stubs()
    path_of = stubs.load("pathlib").Path
    path = path_of("/a") / "b" / "c.tar.gz"
    assert str(path) == "/a/b/c.tar.gz"
    assert (path.name, path.stem, path.suffix, str(path.parent)) == ("c.tar.gz", "c.tar", ".gz", "/a/b")
    assert str(path.with_suffix(".yaml")) == "/a/b/c.tar.yaml"
    assert str(path.parents[1]) == "/a"
    assert path.parts == ("/", "a", "b", "c.tar.gz")
    assert "content of a file" in path.read_text()
    assert "/a/b/c.tar.gz" in path.read_text()
    assert str("/x" / path_of("y")) == "/x/y"
    assert f"{path_of('a', './b/')}" == "a/b"
    assert path_of("/a") == path_of("/a/")


def test_threads_schedule_their_run(stubs: Stubs) -> None:
    threading = stubs.load("threading")
    seen: list[object] = []
    threading.Thread(target=seen.append, args=("x",), daemon=True).start()
    threading.Timer(1.0, seen.append, ["y"]).start()

    class Mine(threading.Thread):  # type: ignore[misc,name-defined]
        def run(self) -> None:
            seen.append("mine")

    mine = Mine()
    mine.start()
    mine.join()
    assert [event for _, _, event in stubs.scheduled] == ["thread", "end of a thread"] * 3
    assert stubs.spins == 1
    for function, args, event in stubs.scheduled:
        if event == "thread":
            function(*args)
    assert seen == ["x", "y", "mine"]


def test_pools_futures_and_exit(stubs: Stubs) -> None:
    with stubs.load("concurrent.futures").ThreadPoolExecutor(max_workers=2) as pool:
        assert pool.submit(lambda x: x + 1, 2).result() == 3
        assert list(pool.map(lambda x: x * 2, [1, 2])) == [2, 4]
    seen: list[object] = []
    stubs.load("atexit").register(seen.append, "end")
    stubs.load("signal").signal(2, lambda *_: seen.append("signal"))
    for function, args, _ in stubs.scheduled[1:]:
        function(*args)
    assert seen == ["end", "signal"]


def test_regular_expressions() -> None:
    re = Stubs().load("re")
    match = re.match(r"(?P<ns>\w+)/(\d+)", "arm/12")
    assert (match.group(), match.group("ns"), match[2], match.groups()) == ("arm/12", "arm", "12", ("arm", "12"))
    assert match.groupdict() == {"ns": "arm"}
    assert match.span() == (0, 6)
    assert re.search("x", "abc") is None
    assert re.compile("[^a-z]").sub("_", "my robot") == "my_robot"
    assert re.findall(r"(\w)(\d)", "a1 b2") == [("a", "1"), ("b", "2")]
    assert re.split(",", "a,b") == ["a", "b"]


def test_iterators(stubs: Stubs) -> None:
    itertools = stubs.load("itertools")
    assert list(itertools.chain([1], (2, 3))) == [1, 2, 3]
    assert list(itertools.chain.from_iterable([[1], [2]])) == [1, 2]
    assert list(itertools.accumulate([1, 2, 3])) == [1, 3, 6]
    assert [(k, list(g)) for k, g in itertools.groupby("aab")] == [("a", ["a", "a"]), ("b", ["b"])]
    assert list(itertools.starmap(pow, [(2, 3)])) == [8]
    assert list(itertools.takewhile(lambda x: x < 3, [1, 3, 2])) == [1]
    assert list(itertools.dropwhile(lambda x: x < 3, [1, 3, 2])) == [3, 2]
    assert list(itertools.batched([1, 2, 3], 2)) == [(1, 2), (3,)]


def test_context_managers() -> None:
    contextlib = Stubs(_begin=next, _end=lambda *_: None, _unwind=lambda *_: None).load("contextlib")

    @contextlib.contextmanager  # type: ignore[untyped-decorator]
    def opened(name: str) -> Any:
        yield f"<{name}>"

    with opened("x") as found:
        assert found == "<x>"
    with contextlib.suppress(KeyError), contextlib.nullcontext(3) as three:
        assert three == 3
    with contextlib.ExitStack() as stack:
        assert stack.enter_context(opened("y")) == "<y>"


def test_single_dispatch_registers_each_class() -> None:
    """Which body runs is up to the model in code; here the last one that fits."""

    def choose(
        registered: list[tuple[type, Callable[..., str]]], functions: list[Callable[..., str]], value: object
    ) -> Callable[..., str]:
        assert len(functions) <= len(registered)
        fitting = [body for cls, body in registered if isinstance(value, cls)]
        return fitting[-1]

    functools = Stubs(_classes=lambda cls, _skip: (cls,), _choose=choose).load("functools")

    @functools.singledispatch  # type: ignore[untyped-decorator]
    def name(_: object) -> str:
        return "any"

    @name.register(int)  # type: ignore[untyped-decorator]
    def _(_: int) -> str:
        return "int"

    assert (name(3), name("3")) == ("int", "any")


def test_queue() -> None:
    queue = Stubs(_any=lambda items: items[0], _alone=lambda: True).load("queue").Queue(maxsize=3)
    queue.put("x")
    assert queue.get() == "x"


def test_configuration(tmp_path: Path) -> None:
    def sections(text: str, _allows: bool) -> list[tuple[str, str | None, str | None]] | None:
        return [("ros", None, None), ("ros", "topic", text)] if text != "?" else None

    config = Stubs(_sections=sections).load("configparser").ConfigParser()
    config.read_string("/a")
    assert (config["ros"]["topic"], config.get("ros", "other", fallback="/b")) == ("/a", "/b")
    assert (config.sections(), config.has_option("ros", "other")) == (["ros"], False)
    (tmp_path / "a.ini").write_text("?", encoding="utf-8")
    config.read(str(tmp_path / "a.ini"))  # as a file of which nothing is known
    assert repr(config["ros"]["topic"]) == "'/a' or '?ros.topic'"
    assert repr(config.get("ros", "other", fallback="/b")) == "'/b' or '?ros.other'"


@pytest.mark.parametrize(
    "name",
    [
        "asyncio",
        "click",
        "numpy",
        "logging",
        "multiprocessing",
        "subprocess",
        "sched",
        "weakref",
        "types",
        "typing",
        "enum",
    ],
)
def test_it_loads(name: str) -> None:
    assert vars(Stubs(_launches=lambda _: None).load(name))
