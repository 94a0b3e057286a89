# SPDX-License-Identifier: Apache-2.0
"""News: said at once, again after changes, many changes as one, and no more when the server ends."""

from __future__ import annotations

import asyncio

from rosward.server.news import News


def test_changes_are_told_and_many_at_once_are_one() -> None:
    async def story() -> int:
        news, told = News(), 0
        stream = news.stream()
        await stream.__anext__()
        for _ in range(50):
            news.tell()
        async for _ in stream:
            told += 1
            if told == 1:
                news.close()
        assert news.streams == 0
        return told

    assert asyncio.run(asyncio.wait_for(story(), 300)) == 1


def test_a_page_that_is_gone_is_forgotten() -> None:
    async def story() -> None:
        news = News()
        stream = news.stream()
        await stream.__anext__()
        assert news.streams == 1
        await stream.aclose()
        assert news.streams == 0

    asyncio.run(story())
