"""The same table through a local Dask cluster."""

from __future__ import annotations

import pytest

from tests.unit.studies.test_sweep import quick, scene
from viscodesign.errors import UsageError

distributed = pytest.importorskip("distributed")

OVER = {"network.tube_radius": "0.3 mm..0.4 mm:4", "fluid": "air,whater"}


@pytest.mark.filterwarnings("ignore")  # those of Dask's own
def test_a_cluster_gives_the_same_table() -> None:
    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=1, dashboard_address=None
    ) as cluster:
        remote = quick(scene(), OVER, cluster=cluster.scheduler_address)
    assert remote.status == "complete"
    assert remote.frame().equals(quick(scene(), OVER).frame())


@pytest.mark.filterwarnings("ignore")
def test_a_cluster_that_is_not_there_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("viscodesign.studies.cluster_rows.CONNECT_S", 0.5)
    with pytest.raises(UsageError, match="no Dask scheduler answers there"):
        quick(scene(), OVER, cluster="tcp://127.0.0.1:9")
