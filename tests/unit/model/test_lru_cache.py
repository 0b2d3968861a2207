"""What is kept for the next who asks: shared where it has no state, lent where it has one."""

from __future__ import annotations

import pytest

from viscodesign.model.lru_cache import LruCache


def test_a_thing_is_made_once_and_the_oldest_makes_room() -> None:
    cache: LruCache[object] = LruCache(2)
    first = cache.get("a", object)
    assert cache.get("a", object) is first
    cache.get("b", object)
    cache.get("a", object)
    cache.get("c", object)
    assert cache.get("a", object) is first
    assert len(cache) == 2


def test_what_is_lent_is_nobody_elses() -> None:
    cache: LruCache[object] = LruCache(2)
    with cache.lend("a", object) as first, cache.lend("a", object) as second:
        assert second is not first
    with cache.lend("a", object) as again:
        assert again in (first, second)


def test_what_failed_is_not_lent_again() -> None:
    cache: LruCache[object] = LruCache(2)
    with pytest.raises(RuntimeError), cache.lend("a", object) as spoiled:
        raise RuntimeError
    with cache.lend("a", object) as fresh:
        assert fresh is not spoiled


def test_no_more_is_kept_for_lending_than_allowed() -> None:
    cache: LruCache[object] = LruCache(2)
    made: list[object] = []

    def make() -> object:
        made.append(object())
        return made[-1]

    for key in ("a", "b", "c"):
        with cache.lend(key, make):
            pass
    for key in ("a", "b", "c"):
        with cache.lend(key, make):
            pass
    assert len(made) == 6
