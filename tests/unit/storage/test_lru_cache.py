"""The cache: stateless results are shared, stateful ones lent."""

from __future__ import annotations

import os
import sys
import threading

import pytest

from viscodesign.storage.lru_cache import ONE_AT_A_TIME, LruCache


def test_results_are_cached_and_the_oldest_dropped() -> None:
    cache: LruCache[object] = LruCache(2)
    first = cache.get("a", object)
    assert cache.get("a", object) is first
    cache.get("b", object)
    cache.get("a", object)
    cache.get("c", object)
    assert cache.get("a", object) is first
    assert len(cache) == 2


def test_lent_results_are_exclusive() -> None:
    cache: LruCache[object] = LruCache(2)
    with cache.lend("a", object) as first, cache.lend("a", object) as second:
        assert second is not first
    with cache.lend("a", object) as again:
        assert again in (first, second)


def test_a_result_that_raised_is_not_lent_again() -> None:
    cache: LruCache[object] = LruCache(2)
    with pytest.raises(RuntimeError), cache.lend("a", object) as spoiled:
        raise RuntimeError
    with cache.lend("a", object) as fresh:
        assert fresh is not spoiled


def test_lendable_results_are_limited() -> None:
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


def test_lent_or_failed_entries_do_not_count_towards_the_size_limit() -> None:
    cache: LruCache[object] = LruCache(1)
    with cache.lend("spoiled", object):
        pass
    with pytest.raises(RuntimeError), cache.lend("spoiled", object):
        raise RuntimeError
    with cache.lend("away", object):
        pass
    with cache.lend("away", object) as away:
        for key in ("b", "c"):
            with cache.lend(key, object):
                pass
    with cache.lend("away", object) as again:
        assert again is away


@pytest.mark.skipif(sys.platform == "win32", reason="there are no forks")
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*:DeprecationWarning")
def test_a_forked_process_finds_the_lock_free() -> None:
    """Whatever another thread of the parent is making at that moment."""
    held, over = threading.Event(), threading.Event()

    def make() -> int:
        held.set()
        return int(over.wait(0.2))

    other = threading.Thread(target=lambda: LruCache[int](1).get("slow", make))
    other.start()
    held.wait()
    child = os.fork()
    if not child:
        is_free = ONE_AT_A_TIME.acquire(timeout=1.0)
        os._exit(0 if is_free else 1)
    over.set()
    other.join()
    assert os.waitpid(child, 0)[1] == 0
