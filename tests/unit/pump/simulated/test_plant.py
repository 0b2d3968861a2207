"""The closed barrel keeps Boyle's law."""

from __future__ import annotations

import numpy as np
import pytest

from tests.pumps import pump
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.simulated.bench import ClosedGas
from viscodesign.pump.simulated.plant import AMBIENT


def test_half_the_volume_is_twice_the_pressure() -> None:
    drive = ServoDrive(pump(dead_volume=0.0, filled_length=0.08))
    plant = ClosedGas([drive])
    assert plant.advance(0.0, np.array([0.0])) == pytest.approx([0.0])
    assert plant.advance(1.0, np.array([0.04])) == pytest.approx([AMBIENT])
    assert plant.advance(1.0, np.array([-0.08])) == pytest.approx([-AMBIENT / 2])


def test_an_empty_barrel_leaves_the_dead_volume() -> None:
    drive = ServoDrive(pump(dead_volume=5e-6, filled_length=0.08))
    full = drive.area * 0.08 + 5e-6
    assert ClosedGas([drive]).advance(0.0, np.array([0.2])) == pytest.approx(
        [AMBIENT * (full / 5e-6 - 1)]
    )
