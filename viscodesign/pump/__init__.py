"""Plan a pump's motion and play it, on a real pump or a simulated one.

    from viscodesign import load, pump
    scene = load("leg.yaml")
    report = pump.stream(scene, "runs/leg")                # on the simulated board
    at = pump.BoardAddress("dynamixel", "/dev/ttyUSB0")
    report = pump.stream(scene, "runs/leg", at, confirm=lambda text: True)

`plan` turns a scene's pressures into plunger motion; `stream` and `upload` play it, `rehearse`
says what they would send; `record`, `status`, `ports` only read; `calibrate` finds home and
travel; `stop` holds whatever moves. Nothing here prints.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from viscodesign.interrupt import StopRequest
    from viscodesign.pump.bus.ports import ports
    from viscodesign.pump.planning.plan import plan
    from viscodesign.pump.planning.result import PumpPlan
    from viscodesign.pump.sessions.calibrating import calibrate
    from viscodesign.pump.sessions.connection import BoardAddress
    from viscodesign.pump.sessions.dry_run import rehearse
    from viscodesign.pump.sessions.inspecting import status, stop
    from viscodesign.pump.sessions.recording import record
    from viscodesign.pump.sessions.streaming import stream
    from viscodesign.pump.sessions.uploading import upload

__all__ = [
    "BoardAddress",
    "PumpPlan",
    "StopRequest",
    "calibrate",
    "plan",
    "ports",
    "record",
    "rehearse",
    "status",
    "stop",
    "stream",
    "upload",
]

_HOMES = {
    "BoardAddress": "sessions.connection",
    "PumpPlan": "planning.result",
    "StopRequest": ".interrupt",
    "calibrate": "sessions.calibrating",
    "plan": "planning.plan",
    "ports": "bus.ports",
    "record": "sessions.recording",
    "rehearse": "sessions.dry_run",
    "status": "sessions.inspecting",
    "stop": "sessions.inspecting",
    "stream": "sessions.streaming",
    "upload": "sessions.uploading",
}


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for."""
    import importlib

    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(f".{_HOMES[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """What there is to import, whether it has been asked for or not."""
    return sorted(__all__)
