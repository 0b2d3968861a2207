"""Drive a pump from Python: rehearse, stream, upload and record, all on the simulated board.

On a real one, `pump.BoardAddress("dynamixel", "/dev/ttyUSB0")` takes the place of ``BOARD``, and
``confirm`` is asked before anything moves.
"""

from pathlib import Path
from tempfile import mkdtemp

import pandas as pd

from viscodesign import load, pump

CONFIG = Path(__file__).parents[1] / "configs" / "leg_16_pump.yaml"
BOARD = pump.BoardAddress("simulated", pace="max")


def confirm(text: str) -> bool:
    """Agree to a plan: here after printing what it plays."""
    print(next(line.strip() for line in text.splitlines() if line.strip().startswith("plays")))
    return True


folder = Path(mkdtemp())
scene = load(
    CONFIG,
    ["input={kind: sine, amplitude: 4 kPa, frequency: 0.5 Hz}", "run={duration: 2 s}"],
)

rehearsal = pump.rehearse(scene, BOARD)
print(f"a stream would send {len(rehearsal.packets)} packets")

streamed = pump.stream(scene, folder, BOARD, rate=30.0, confirm=confirm)
table = pd.read_csv(folder / "record.csv")
print(f"streamed: {streamed.status}, {len(table)} samples, "
      f"tip moved by {1e3 * (table['tip_x_m'].max() - table['tip_x_m'].min()):.1f} mm")  # fmt: skip

uploaded = pump.upload(scene, BOARD, playback="once", tolerance="1 kPa", confirm=confirm)
print(f"uploaded: {uploaded.status}, {uploaded.document()['moves']} moves")

recorded = pump.record(folder / "rest.csv", BOARD, scene, duration=1.0)
print(f"recorded: {recorded.status}, {recorded.rows} rows")
