"""Plan a pump's motion and play it, on a real pump or a simulated one.

    from viscodesign import load, pump
    scene = load("leg.yaml")
    report = pump.stream(scene, "runs/leg")                # on the simulated board
    at = pump.BoardAddress("dynamixel", "/dev/ttyUSB0")
    report = pump.stream(scene, "runs/leg", at, confirm=lambda text: True)

`plan` turns a scene's pressures into the motion of its pump, of whatever kind; `stream` and
`upload` play it, `rehearse`
says what they would send; `record`, `status`, `ports` only read; `calibrate` finds home and
travel; `stop` holds whatever moves. Nothing here prints.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from viscodesign.lazy_names import lazy_names

if TYPE_CHECKING:
    from viscodesign.interrupt import StopRequest as StopRequest
    from viscodesign.pump.bus.ports import ports as ports
    from viscodesign.pump.planning.plan import plan as plan
    from viscodesign.pump.planning.result import PumpPlan as PumpPlan
    from viscodesign.pump.sessions.calibrating import calibrate as calibrate
    from viscodesign.pump.sessions.connection import BoardAddress as BoardAddress
    from viscodesign.pump.sessions.dry_run import rehearse as rehearse
    from viscodesign.pump.sessions.inspecting import record as record
    from viscodesign.pump.sessions.inspecting import status as status
    from viscodesign.pump.sessions.inspecting import stop as stop
    from viscodesign.pump.sessions.streaming import stream as stream
    from viscodesign.pump.sessions.uploading import upload as upload

_HOMES = {
    "BoardAddress": ".sessions.connection",
    "PumpPlan": ".planning.result",
    "StopRequest": "..interrupt",
    "calibrate": ".sessions.calibrating",
    "plan": ".planning.plan",
    "ports": ".bus.ports",
    "record": ".sessions.inspecting",
    "rehearse": ".sessions.dry_run",
    "status": ".sessions.inspecting",
    "stop": ".sessions.inspecting",
    "stream": ".sessions.streaming",
    "upload": ".sessions.uploading",
}
"""Where each name is imported from when it is first asked for: `--help` needs none of them."""

__all__ = [*_HOMES]

__getattr__, __dir__ = lazy_names(__name__, _HOMES)
