"""Gas that speeds up along a tube and chokes, against an own integration and a library.

The integration follows the momentum balance along the tube, slice by slice. The library
`fluids` has isothermal flow of a gas with friction (Crane TP 410, equation 1-6) and the
pressure at which it chokes. Nothing of the package is used for either.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from fluids.compressible import P_isothermal_critical_flow, isothermal_gas
from fluids.friction import Churchill_1977
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from tests.scenes import leg
from tests.validation.rc_network import AMBIENT, COMPLIANCE, REST_VOLUME, only
from viscodesign import Trajectory, simulate
from viscodesign.physics import choking, gas

DENSITY, VISCOSITY = 1.2, 1.8e-5
"""Of the gas, at ambient pressure."""
LENGTH = 0.05
NARROW, WIDE = 4e-5, 5e-4
"""Radii [m]: laminar up to choking, and turbulent."""
ENDS = 1.5
"""Losses at both ends, in dynamic pressures."""
FINE = "accuracy=1e-6"
PRESSURES = [
    (1.0001, 1.0),
    (1.01, 1.0),
    (1.3, 1.0),
    (2.0, 1.0),
    (5.0, 1.0),
    (20.0, 1.0),
    (1.0, 0.8),
    (1.0, 0.02),
]
"""Absolute pressures at start and end, in ambient ones."""


def friction(flux: float, radius: float, turbulent: bool) -> float:
    """Darcy's factor times length over diameter, with the losses at the ends [1]."""
    reynolds = 2 * radius * flux / VISCOSITY
    if not turbulent:
        return 64 / reynolds * LENGTH / (2 * radius)
    factor = 64 / reynolds if reynolds < 1 else float(Churchill_1977(Re=reynolds, eD=0.0))
    return factor * LENGTH / (2 * radius) + ENDS


def density(pressure: float, exponent: float) -> float:
    return float(DENSITY * (pressure / AMBIENT) ** (1 / exponent))


def way(flux: float, before: float, behind: float, exponent: float) -> float:
    """Friction, as `friction`, that a flux [kg/(m2 s)] meets from one pressure to another [Pa].

    A slice takes -rho dP = G^2 rho d(1/rho) + G^2/2 df, and d(1/rho) follows the pressure;
    here by its logarithm, at the points of Gauss and Legendre.
    """
    points, weights = np.polynomial.legendre.leggauss(60)
    middle, half = math.log(before * behind) / 2, math.log(before / behind) / 2
    pressure = np.exp(middle + half * points)
    rho = DENSITY * (pressure / AMBIENT) ** (1 / exponent)
    return float(half * weights @ (2 * rho * pressure / flux**2 - 2 / exponent))


def choked_at(flux: float, exponent: float) -> float:
    """Pressure at which a flux moves with the gas's own speed of sound [Pa]."""
    low, high = math.log(1e-9 * AMBIENT), math.log(1e3 * AMBIENT)
    return math.exp(
        brentq(
            lambda p: math.exp(p) * exponent * density(math.exp(p), exponent) - flux**2,
            low,
            high,
            xtol=1e-15,
            rtol=1e-14,
        )
    )


def integrated(
    before: float, behind: float, radius: float, turbulent: bool, exponent: float = 1.0
) -> tuple[float, float]:
    """Mass flux [kg/(m2 s)], and the speed at the exit over that of sound [1]."""

    def missing(logarithm: float) -> float:
        flux = math.exp(logarithm)
        leaving = max(behind, choked_at(flux, exponent))
        met = way(flux, before, leaving, exponent) if leaving < before else 0.0
        return met - friction(flux, radius, turbulent)

    most = math.sqrt(exponent * before * density(before, exponent))
    flux = math.exp(brentq(missing, math.log(1e-7 * most), math.log(most), xtol=1e-13))
    leaving = max(behind, choked_at(flux, exponent))
    return flux, flux / math.sqrt(exponent * leaving * density(leaving, exponent))


def by_law(
    before: float, behind: float, radius: float, turbulent: bool, exponent: float = 1.0
) -> float:
    """The mass flux that friction and the package's own law let through."""
    area = math.pi * radius**2
    coefficient = choking.momentum_coefficient(DENSITY, radius)
    start, end = before - AMBIENT, behind - AMBIENT
    driving = gas.density_integral(start, AMBIENT, exponent) - gas.density_integral(
        end, AMBIENT, exponent
    )

    def missing(flow: float) -> float:
        flux = DENSITY * flow / area
        lost = friction(flux, radius, turbulent) * flux**2 / (2 * DENSITY)
        own = choking.acceleration_drop(flow, start, end, AMBIENT, exponent, coefficient)
        return float(driving - lost - own)

    most = area / DENSITY * math.sqrt(exponent * before * density(before, exponent))
    return DENSITY / area * brentq(missing, 1e-7 * most, most, xtol=1e-25, rtol=1e-13)


@pytest.mark.parametrize("exponent", [1.0, 1.2, 1.4])
@pytest.mark.parametrize(("radius", "turbulent"), [(NARROW, False), (WIDE, True)])
@pytest.mark.parametrize(("before", "behind"), PRESSURES)
def test_the_law_is_the_integral_of_the_momentum_along_the_tube(
    before: float, behind: float, radius: float, turbulent: bool, exponent: float
) -> None:
    case = (before * AMBIENT, behind * AMBIENT, radius, turbulent, exponent)
    flux, speed = integrated(*case)
    assert speed <= 1 + 1e-9
    assert by_law(*case) == pytest.approx(flux, rel=1e-8)


def test_the_cases_reach_from_slow_flow_to_choking() -> None:
    for radius, turbulent in ((NARROW, False), (WIDE, True)):
        speeds = [integrated(a * AMBIENT, b * AMBIENT, radius, turbulent)[1] for a, b in PRESSURES]
        assert min(speeds) < 0.01
        assert max(speeds) == pytest.approx(1.0, abs=1e-9)
        assert any(0.2 < speed < 0.9 for speed in speeds)


@pytest.mark.parametrize(("before", "behind"), PRESSURES)
def test_isothermal_flow_is_that_of_a_library(before: float, behind: float) -> None:
    found = by_law(before * AMBIENT, behind * AMBIENT, WIDE, True)
    factor = friction(found, WIDE, True) * 2 * WIDE / LENGTH
    critical = P_isothermal_critical_flow(P=before * AMBIENT, fd=factor, D=2 * WIDE, L=LENGTH)
    known = isothermal_gas(
        rho=DENSITY * before,
        fd=factor,
        P1=before * AMBIENT,
        P2=max(behind * AMBIENT, critical * (1 + 1e-9)),
        L=LENGTH,
        D=2 * WIDE,
    )
    assert found * math.pi * WIDE**2 == pytest.approx(known, rel=1e-7)


def test_slow_flow_is_that_without_the_term() -> None:
    """Beside friction it is the Mach number squared: round-off at a millionth."""
    ratio, coefficient = 1.3, choking.momentum_coefficient(DENSITY, WIDE)
    speed_of_sound = math.sqrt(AMBIENT / DENSITY)
    for mach in (1e-3, 1e-6):
        flow = mach * ratio * speed_of_sound * math.pi * WIDE**2
        start, end = 0.3 * AMBIENT, 0.29999 * AMBIENT
        driving = gas.density_integral(start, AMBIENT, 1.0) - gas.density_integral(
            end, AMBIENT, 1.0
        )
        own = choking.acceleration_drop(flow, start, end, AMBIENT, 1.0, coefficient)
        assert own / driving == pytest.approx(mach**2, rel=1e-3)
        assert choking.mach_squared(flow, ratio, AMBIENT, 1.0, coefficient) == pytest.approx(
            mach**2
        )


def test_flow_follows_the_pressures_without_kinks() -> None:
    """Slopes from both sides agree where the flow reverses, and where it begins to choke."""

    def slope(behind: float, step: float) -> float:
        pair = [_signed(AMBIENT, behind + s * step) for s in (0.0, 1.0)]
        return (pair[1] - pair[0]) / step

    def kink(behind: float) -> float:
        """Of the slopes, as a part of the largest one, without what curvature makes of it."""
        sides = [
            2 * slope(behind, 0.5 * step) - slope(behind, step)
            for step in (-0.01 * AMBIENT, 0.01 * AMBIENT)
        ]
        return abs(sides[1] - sides[0])

    steep = abs(slope(0.9 * AMBIENT, 1.0))
    flux, _ = integrated(AMBIENT, 1e-3 * AMBIENT, NARROW, False)
    begins = choked_at(flux, 1.0)
    assert kink(begins) <= 0.01 * steep
    assert kink(AMBIENT) <= 0.01 * steep
    assert abs(slope(begins, -0.5 * begins)) <= 1e-12 * steep


def _signed(before: float, behind: float) -> float:
    """The flux by the law, in either direction."""
    if before == behind:
        return 0.0
    high, low = max(before, behind), min(before, behind)
    return math.copysign(by_law(high, low, NARROW, False), before - behind)


def test_losses_at_the_ends_may_count_as_friction() -> None:
    """The largest flow through an entrance alone, by the work of the gas on its way into it.

    P_0 ln(P/P_a) + (1 + K) v^2 rho_0 / 2 = 0 with an entrance loss K = 0.5; it is largest at
    ln(P_a/P) = 1/2. The law knows K and the jet's loss at the exit, and no entrance.
    """
    entrance, jet = 0.5, 1.0
    largest = math.sqrt(math.exp(-1) / (1 + entrance))

    def missing(flux: float) -> float:
        choked = gas.density_integral((flux - 1) * AMBIENT, AMBIENT, 1.0) / AMBIENT
        return -choked - flux**2 * (math.log(1 / flux) + (entrance + jet) / 2)

    assert brentq(missing, 1e-3, 1.0) == pytest.approx(largest, rel=0.04)


# -- whole simulations --------------------------------------------------------------


def tube(radius: float, before: float, behind: float, effects: str, exponent: float) -> Trajectory:
    """Gas through one tube between two pressures [Pa]; a bellow beside the higher one."""
    fuller = "a" if before > behind else "b"
    found = simulate(
        leg(
            "bellows.count=2",
            f"network={{layout: custom, tube_radius: {radius}, tube_length: {LENGTH}, "
            f"entrance_loss: 0.5, exit_loss: 1, tubes: [{{from: a, to: b}}, {{from: {fuller}, to: R1}}]}}",
            "input=null",
            f"inputs={{a: {{kind: constant, value: {before - AMBIENT!r}}}, "
            f"b: {{kind: constant, value: {behind - AMBIENT!r}}}}}",
            f"fluid={{name: a gas, viscosity: {VISCOSITY}, density: {DENSITY}, "
            f"gas_constant: 288, polytropic_exponent: {exponent}}}",
            "run={duration: 0.1 s}",
            effects,
            FINE,
        ),
        verify=False,
    )
    assert found.status == "complete", found.failure
    return found


@pytest.mark.parametrize("reverse", [False, True])
@pytest.mark.parametrize("exponent", [1.0, 1.4])
@pytest.mark.parametrize(("radius", "turbulent"), [(NARROW, False), (WIDE, True)])
@pytest.mark.parametrize(("before", "behind"), [(1.01, 1.0), (1.3, 1.0), (1.2, 0.1)])
def test_a_simulated_tube_lets_through_what_the_integration_says(
    before: float, behind: float, radius: float, turbulent: bool, exponent: float, reverse: bool
) -> None:
    names = ["gas_compressibility", "choked_flow", *(["flow_regime"] if turbulent else [])]
    ends = (before * AMBIENT, behind * AMBIENT)
    found = tube(radius, *(ends[::-1] if reverse else ends), only(*names), exponent)
    flux, _ = integrated(*ends, radius, turbulent, exponent)
    expected = math.copysign(flux * math.pi * radius**2 / DENSITY, -1 if reverse else 1)
    assert found.flow[-1, 0] == pytest.approx(expected, rel=1e-6)
    assert not {"choking", "fast_gas"} & {notice.code for notice in found.warnings}


def test_a_bellow_fills_through_a_choked_tube() -> None:
    """Its pressure against time; the flow is constant until the bellow pushes back."""
    before, radius, end = 4.0 * AMBIENT, 3e-4, 0.4
    times = np.linspace(0.0, end, 21)
    found = simulate(
        leg(
            "bellows.count=2",
            f"network={{layout: custom, tube_radius: {radius}, tube_length: {LENGTH}, "
            "tubes: [{from: a, to: R1}]}",
            "input=null",
            f"inputs={{a: {{kind: step, value: {before - AMBIENT!r}, time: 0}}}}",
            f"fluid={{name: a gas, viscosity: {VISCOSITY}, density: {DENSITY}, gas_constant: 288}}",
            f"run={{duration: {end}, start: rest, output_times: {times.tolist()}}}",
            only("gas_compressibility", "choked_flow"),
            "accuracy=1e-5",
        ),
        verify=False,
    )
    assert found.status == "complete", found.failure

    def rate(_: float, pressure: np.ndarray) -> list[float]:
        flux = by_law(before, AMBIENT + float(pressure[0]), radius, False)
        flow = flux * math.pi * radius**2 / DENSITY
        # Stored: (V_0 + C p)(1 + p/P_0), at ambient density.
        stiffness = COMPLIANCE * (1 + pressure[0] / AMBIENT)
        return [flow / (stiffness + (REST_VOLUME + COMPLIANCE * pressure[0]) / AMBIENT)]

    known = solve_ivp(rate, (0.0, end), [0.0], t_eval=times, rtol=1e-9, atol=1e-3).y[0]
    moved = found.pressure[:, found.bellows.index("R1")]
    speeds = [integrated(before, AMBIENT + p, radius, False)[1] for p in known[[0, -1]]]
    assert speeds[0] == pytest.approx(1.0, abs=1e-9)
    assert speeds[1] < 0.99
    assert moved == pytest.approx(known, abs=1e-4 * np.max(known))
