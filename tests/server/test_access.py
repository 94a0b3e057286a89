# SPDX-License-Identifier: Apache-2.0
"""Who is let in: the token, the cookie, the names of the server, and which pages may ask for something."""

from __future__ import annotations

from pathlib import Path

import pytest
from starlette.testclient import TestClient

from rosward.server.security import Access, Hosts

from .page import ORIGIN, OWN_PAGE, PORT, Page, opened

EVERYWHERE = [
    "/",
    "/assets/page.css",
    "/api/results",
    "/api/news",
    "/results/0123456789abcdef",
    "/results/0123456789abcdef/report",
    "/results/0123456789abcdef/files/policy.xml",
]
CHANGES = [
    "/api/uploads",
    "/api/workspaces",
    "/api/examples/talker",
    "/api/results/0123456789abcdef/again",
    "/api/results/0123456789abcdef/cancel",
    "/api/results/0123456789abcdef/delete",
    "/api/results/0123456789abcdef/watch",
]


def stranger(page: Page) -> TestClient:
    """A browser that has not opened the address with the token."""
    return TestClient(page.client.app, base_url=ORIGIN, follow_redirects=False)


def test_without_the_token_there_is_nothing(page: Page) -> None:
    for address in EVERYWHERE:
        answer = stranger(page).get(address)
        assert (answer.status_code, "rosward serve" in answer.text) == (403, True), address
        assert "set-cookie" not in answer.headers


def test_without_the_token_nothing_is_done(page: Page) -> None:
    for address in CHANGES:
        assert stranger(page).post(address, json={}, headers=OWN_PAGE).status_code == 403, address
    assert page.results() == []


def test_a_wrong_token_is_refused_even_with_the_cookie(page: Page) -> None:
    for given in ("x", page.access.token[:-1], page.access.token + "x", page.access.token.swapcase(), "é"):
        assert page.client.get("/", params={"token": given}).status_code == 403


def test_the_token_becomes_a_cookie_that_no_script_and_no_other_site_has(page: Page) -> None:
    answer = stranger(page).get(f"/?token={page.access.token}")
    assert answer.status_code == 200
    name, *rules = answer.headers["set-cookie"].split("; ")
    assert name == f"rosward-{PORT}={page.access.token}"
    assert set(rules) == {"HttpOnly", "SameSite=Strict", "Path=/"}


def test_the_token_opens_any_page_but_does_nothing(page: Page) -> None:
    assert stranger(page).get(f"/api/results?token={page.access.token}").status_code == 200
    answer = stranger(page).post(f"/api/examples/talker?token={page.access.token}", json={}, headers=OWN_PAGE)
    assert answer.status_code == 403


def test_a_ticket_is_good_for_one_use(page: Page) -> None:
    ticket = page.access.ticket()
    assert ticket != page.access.token
    assert [stranger(page).get(f"/?token={ticket}").status_code for _ in range(2)] == [200, 403]


@pytest.mark.parametrize("other", ['{"a": "b, c"}', "a b=c", '"', "=", "é"])
def test_cookies_of_other_servers_of_this_machine_do_not_matter(page: Page, other: str) -> None:
    """A browser sends the cookies of all ports."""
    sent = f'x={other}; rosward-{PORT}={page.access.token}; y="{other}'
    assert stranger(page).get("/", headers={b"Cookie": sent.encode()}).status_code == 200


@pytest.mark.parametrize(
    "cookie", ["", "x=y", f"rosward-{PORT}=", f"rosward-{PORT}=wrong", "rosward-1=TOKEN", ";;=;\x7f"]
)
def test_another_cookie_is_refused(page: Page, cookie: str) -> None:
    sent = cookie.replace("TOKEN", page.access.token)
    assert stranger(page).get("/", headers={"Cookie": sent}).status_code == 403


def test_under_another_name_it_does_not_answer(page: Page) -> None:
    """A page of evil.example whose name was made to lead to 127.0.0.1 sends its own name, and our cookie is not even asked for."""
    for host in (
        "evil.example",
        f"evil.example:{PORT}",
        f"127.0.0.1.evil.example:{PORT}",
        "127.0.0.1",
        "127.0.0.1:80",
        f"127.0.0.2:{PORT}",
        f"user@127.0.0.1:{PORT}",
        f"127.0.0.1:{PORT}, evil.example",
        "",
    ):
        assert page.client.get("/", headers={"Host": host}).status_code == 421, host


def test_under_its_own_names_it_answers(page: Page) -> None:
    for host in (f"127.0.0.1:{PORT}", f"localhost:{PORT}", f"LOCALHOST:{PORT}"):
        assert page.client.get(f"/?token={page.access.token}", headers={"Host": host}).status_code == 200


def test_where_other_machines_may_ask_an_address_is_a_name() -> None:
    hosts = Hosts({"robot"}, PORT, numbers=True)
    assert [hosts.has(f"{h}:{PORT}") for h in ("robot", "192.168.1.7", "[fe80::1]", "evil.example")] == [
        True,
        True,
        True,
        False,
    ]


@pytest.mark.parametrize(
    "headers",
    [
        {"Origin": "http://evil.example"},
        {"Origin": "http://evil.example", "Sec-Fetch-Site": "same-origin"},
        {"Origin": "null"},
        {"Origin": "http://127.0.0.1:9999", "Sec-Fetch-Site": "same-site"},
        {"Origin": f"https://127.0.0.1:{PORT}"},
        {"Origin": ORIGIN, "Sec-Fetch-Site": "cross-site"},
        {"Origin": ORIGIN, "Sec-Fetch-Site": "same-site"},
        {"Sec-Fetch-Site": "cross-site"},
        {"Sec-Fetch-Site": "none"},
        {},
    ],
)
def test_another_page_changes_nothing(page: Page, headers: dict[str, str]) -> None:
    for address in CHANGES:
        assert page.client.post(address, json={}, headers=headers).status_code == 403, address
    assert page.results() == []


@pytest.mark.parametrize("site", ["cross-site", "same-site"])
def test_another_page_embeds_nothing(page: Page, site: str) -> None:
    """`same-site` is any other port of this machine."""
    headers = {"Sec-Fetch-Site": site, "Sec-Fetch-Mode": "no-cors", "Sec-Fetch-Dest": "script"}
    for address in EVERYWHERE:
        assert page.client.get(address, headers=headers).status_code == 403, address


def test_nothing_is_said_to_other_origins(page: Page) -> None:
    answer = page.client.get("/api/results", headers={"Origin": "http://evil.example"})
    assert not [name for name in answer.headers if name.startswith("access-control-")]
    assert page.client.options("/api/uploads", headers=OWN_PAGE).status_code in {403, 405}


@pytest.mark.parametrize("address", ["/", "/assets/start.js", "/api/results", "/nothing"])
def test_every_answer_is_guarded(page: Page, address: str) -> None:
    headers = page.client.get(address).headers
    policy = dict(rule.strip().split(" ", 1) for rule in headers["content-security-policy"].split(";"))
    assert policy["default-src"] == "'none'"
    assert policy["script-src"] == "'self'"
    assert policy["frame-ancestors"] == "'none'"
    assert headers["x-content-type-options"] == "nosniff"
    assert headers["referrer-policy"] == "no-referrer"
    assert headers["cross-origin-resource-policy"] == "same-origin"
    assert headers["cache-control"] == "no-store"


def test_the_report_is_in_a_sandbox_of_its_own(page: Page) -> None:
    done = page.wait(page.post("/api/examples/talker")["id"])
    policy = page.client.get(f"/results/{done['id']}/report").headers["content-security-policy"]
    assert policy.startswith("sandbox allow-scripts allow-downloads; default-src 'none'")
    assert "allow-same-origin" not in policy
    assert "frame-ancestors 'self'" in policy
    shown = page.client.get(f"/results/{done['id']}").text
    assert 'sandbox="allow-scripts allow-downloads"' in shown


def test_two_servers_have_two_tokens() -> None:
    assert Access(1).token != Access(1).token
    assert len(Access(1).token) >= 40


def test_where_other_machines_may_ask_no_folder_is_named(tmp_path: Path) -> None:
    with opened(tmp_path / "results", names_paths=False) as page:
        assert "reached from other machines" in page.refused("/api/workspaces", {"path": str(tmp_path)})
        assert 'id="path"' not in page.client.get("/").text
