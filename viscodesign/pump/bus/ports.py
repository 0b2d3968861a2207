"""Serial ports of this machine."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from viscodesign.errors import PumpError
from viscodesign.lazy_dataclass import dataclass

LATENCY = Path("/sys/bus/usb-serial/devices")
"""Where Linux keeps how long an FTDI adapter collects bytes before it passes them on."""


@dataclass(frozen=True)
class Port:
    """A port and what is known of it."""

    name: str
    description: str
    maker: str
    serial_number: str
    hint: str
    """What would make it better, or nothing."""


@contextmanager
def serial_library() -> Iterator[None]:
    """Say what ports need where the library for them cannot be imported."""
    try:
        yield
    except ImportError as error:
        raise PumpError(
            f"serial ports need pyserial, which cannot be imported here ({error}). Install it "
            "with: pip install pyserial; planning and the simulated board work without it"
        ) from error


def ports() -> list[Port]:
    """All serial ports that the system knows, by name. Raises `PumpError` without pyserial."""
    with serial_library():
        from serial.tools import list_ports

    return [
        Port(
            each.device,
            each.description or "",
            each.manufacturer or "",
            each.serial_number or "",
            latency_hint(each.device),
        )
        for each in sorted(list_ports.comports(), key=lambda each: str(each.device))
    ]


def latency_hint(port: str, devices: Path = LATENCY) -> str:
    """How to make a slow FTDI adapter quick: from 16 ms, some 60 questions a second, to 1 ms."""
    timer = devices / Path(port).resolve().name / "latency_timer"
    try:
        milliseconds = int(timer.read_text())
    except (OSError, ValueError):
        return ""
    if milliseconds <= 1:
        return ""
    return (
        f"latency timer is {milliseconds} ms, too slow for fast streaming; "
        f"lower it with: echo 1 | sudo tee {timer}"
    )
