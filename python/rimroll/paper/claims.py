"""Every number that the paper states, beside rimroll's.

A printed number agrees when ours rounds to it: when they differ by no more than half of the last
digit printed, or of what "about" leaves open, which is stated with the claim.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from rimroll import bodies
from rimroll.bodies.body import Body
from rimroll.figures.style import superscript
from rimroll.laws import Frictionless, NoSlip
from rimroll.motion import Motion, simulate
from rimroll.paper.figures import disks_against_friction as disks
from rimroll.paper.figures import turn_against_friction as dry
from rimroll.paper.setting import CAN, GRAVITY, LAWS, motion, start
from rimroll.theory import closed_forms

AGREES, CUT, DIFFERS, MEASURED = "agrees", "cut, not rounded", "differs", "measured"
INPUT = "input"


@dataclass(frozen=True)
class Claim:
    """A number of the paper and ours; ``within`` is how far apart they may be and still agree."""

    where: str
    says: str
    printed: float
    unit: str
    ours: float | None
    within: float
    remark: str = ""
    digits: int = 2
    stated: bool = True
    """Whether the paper prints the number; else it follows from what the paper says."""
    is_input: bool = False
    """Whether rimroll takes the number from the paper, so that to agree proves nothing."""

    @property
    def verdict(self) -> str:
        """``agrees``, ``cut, not rounded``, ``differs``; ``measured`` or ``input`` when rimroll computes nothing."""
        if self.ours is None:
            return MEASURED
        if self.is_input:
            return INPUT
        excess = self.ours - self.printed
        if abs(excess) <= self.within:
            return AGREES
        return CUT if 0 < excess < 2 * self.within else DIFFERS

    @property
    def printed_text(self) -> str:
        """The paper's number as it prints it, or in brackets as it follows from what it says."""
        text = f"{self.printed:g}".replace("-", "−")
        return text if self.stated else f"({text})"

    @property
    def ours_text(self) -> str:
        """Our number with the claim's digits; in powers of ten when ``digits`` is negative."""
        if self.ours is None:
            return "–"
        if self.digits < 0 and self.ours != 0.0:
            power = math.floor(math.log10(abs(self.ours)))
            return f"{self.ours / 10.0**power:.1f} × 10{superscript(power)}"
        return f"{self.ours:.{max(self.digits, 0)}f}".replace("-", "−")


def _limit(body: Body, law: NoSlip | Frictionless) -> float:
    return float(np.degrees(closed_forms.turn_limit(body, law)))


def angles_of_the_can() -> list[Claim]:
    """The two limiting angles and the deviations from 180 degrees."""
    rolling, sliding = _limit(CAN, NoSlip()), _limit(CAN, Frictionless())
    printed_formula = 180.0**2 / rolling
    cut = "The paper cuts 220.97 where rounding gives 221."
    return [
        Claim("Quantitative comparisons", "angle of turn, frictionless: “about 220”", 220, "°",
              sliding, 0.5, cut),
        Claim("Quantitative comparisons", "angle of turn, no slip: 202", 202, "°", rolling, 0.5),
        Claim("Histogram, caption", "frictionless theory: 180 ± 40", 40, "°", sliding - 180, 0.5,
              "220.97 − 180 = 40.97, cut to 40; rounding gives 41."),
        Claim("Histogram, caption", "no-slip theory: 180 ± 22", 22, "°", rolling - 180, 0.5),
        Claim("Eq. (15)", "no-slip formula as printed, π√((A+mH²)/(A+mR²+mH²)), "
              "put in numbers", printed_formula, "°", rolling, 0.5,
              "The fraction is printed upside down. The right one, π√((A+mR²+mH²)/(A+mH²)), is what the "
              "paper itself evaluated: it gives the 202° of its text."),
        Claim("Eq. (15), text", "“numerical integrations agree quite well with this "
              "formula”: turn of the simulated can at ε = 0.005", rolling, "°",
              float(np.degrees(motion(NoSlip()).turns[1].angle)), 0.5,
              "This is true of the corrected formula.", digits=3),
        Claim("Quantitative comparisons", "the limiting angle “does not depend on the initial conditions”: "
              "largest difference between two starts, at no slip and at no friction, ε = 10⁻⁶ rad/s", 0, "°",
              _largest_difference_between_starts(), 0.01, "This holds at the paper’s two limits. Under dry "
              f"friction of μ = 0.1 the same starts give {dry.near_collision(0.1, dry.ROCKED):.2f}° and "
              f"{dry.near_collision(0.1, dry.FLICKED):.2f}°, since one comes down sliding faster than the other.",
              digits=-1, stated=False),
    ]  # fmt: skip


def _largest_difference_between_starts() -> float:
    """The near-collision's turn, degrees, in whole motions that roll (μ > μ*) or have no
    friction."""
    turns = [
        [dry.measured_step(dry.motion(friction, start, dry.CLOSEST)) for start in dry.STARTS]
        for friction in (0.0, 0.5)
    ]
    return float(np.max(np.ptp(turns, axis=1)))


def disks_and_rings() -> list[Claim]:
    """The section on disks: angles as multiples of π and against a full turn."""
    disk = _limit(bodies.disk(0.1), NoSlip())
    ring = _limit(bodies.ring(0.1), NoSlip())
    both = "Without friction it is the same to the last digit."
    straight_back = (2 / 3) ** 0.5
    dragged = disks.whole_turn("uniform disk", 0.8, dry.ROCKED) - disk
    return [
        Claim("Disks", "homogeneous disk: π√5 ≈ 2.23 π", 2.23, "π", disk / 180, 0.005,
              "√5 = 2.236, cut to 2.23; rounding gives 2.24. " + both, digits=4),
        Claim("Disks", "… “about 41 degrees more than a full rotation”", 41, "°", disk - 360, 0.5,
              "0.23 π is 41°; (√5 − 2) π = 0.236 π is 42.49°: this follows from the cut."),
        Claim("Disks", "ring: π√3 ≈ 1.73 π", 1.73, "π", ring / 180, 0.005, both, digits=4),
        Claim("Disks", "… “about 48 degrees less than a full rotation”", 48, "°", 360 - ring, 0.5),
        Claim("Disks", "disk and ring “differ by about 90 degrees”", 90, "°", disk - ring, 1.0),
        Claim("Disks", "between ring and disk (k from 0.707 to 1) one bounces straight back: its turn",
              360, "°", float(np.degrees(closed_forms.disk_turn_limit(straight_back))), 1e-9,
              f"k = √(2/3) = {straight_back:.4f}."),
        Claim("Disks", "“no dependence … on the form of the friction law or the magnitude of the friction”: "
              "largest difference of the near-collision from π√(2+k²)/k", 0, "°", disks.spread_of_the_step(), 1e-6,
              f"Disk and ring under {len(disks.LAWS)} laws, each from two starts.", digits=-1, stated=False),
        Claim("Disks", "… and of the turn from the release to the next tilt maximum: uniform disk at μ = 0.8",
              0, "°", dragged, 0.5, "Sliding on the way down leaves slip and spin, which turn the disk further "
              "as it rises: by this much relative to the limit, however close the near-collision. The step itself "
              "is as the paper says.", stated=False),
        Claim("Abstract; Tall thin containers", "tall containers: tends to π (here H = 100 R)", 180, "°",
              _limit(bodies.cylinder(0.01, 2.0), Frictionless()), 0.5,
              "Solid cylinder without friction; without slip it is still closer.", digits=3),
    ]  # fmt: skip


def experiment() -> list[Claim]:
    """The histogram of 42 flicks: the measurements, and the limits between which they lie."""
    rolling, sliding = _limit(CAN, NoSlip()), _limit(CAN, Frictionless())

    def between(angle: float) -> str:
        part = (angle - rolling) / (sliding - rolling)
        rest, slid = dry.friction_for(angle), dry.friction_for(angle, dry.ROCKED)
        return (
            f"{100 * part:.0f} % of the way from no slip to frictionless. Dry friction of μ = {rest:.3f} gives "
            f"this turn if the rim comes down at rest, μ = {slid:.3f} if released at {dry.ROCKED.name}."
        )

    where = "Histogram and text"
    return [
        Claim(where, "trials", 42, "", None, 0),
        Claim(where, "mean of the leftward falls: 180 + 33", 213.0, "°", None, 0, between(213.0)),
        Claim(where, "mean of the rightward falls: 180 − 37.9", 217.9, "°", None, 0, between(217.9)),
        Claim(where, "standard deviation, leftward", 3.9, "°", None, 0,
              "The spread is a fifth of the gap between the two limits."),
        Claim(where, "standard deviation, rightward", 4.5, "°", None, 0),
    ]  # fmt: skip


def parameters() -> list[Claim]:
    """The can's parameters as the paper gives them, and those that cannot be right."""
    most = CAN.radius**2
    literal = _caption_taken_literally()
    where = "Simulation figure, caption"
    per_mass = "Per unit mass: the caption gives A and C as if in kg m²."
    return [
        Claim("Quantitative comparisons", "R", 5.1, "cm", 100 * CAN.radius, 0.05, is_input=True),
        Claim("Quantitative comparisons", "H", 6.9, "cm", 100 * CAN.height, 0.05, is_input=True),
        Claim("Quantitative comparisons", "A/m", 5.13, "10⁻³ m²",
              1e3 * CAN.transverse_inertia / CAN.mass, 0.005, is_input=True),
        Claim(where, "m", 0.070, "kg", CAN.mass, 0.0005, digits=3, is_input=True),
        Claim(where, "A = 5.1 × 10⁻³", 5.1, "10⁻³ m²", 1e3 * CAN.transverse_inertia / CAN.mass, 0.05,
              per_mass, is_input=True),
        Claim(where, "C = 8 × 10⁻³: largest C/m possible inside the rim, R²", 8, "10⁻³ m²", 1e3 * most,
              0.5, "Impossible even per unit mass: C/m is the mean square of the distance from the axis. "
              f"rimroll uses {1e3 * CAN.axial_inertia / CAN.mass:.1f}; no limiting angle depends on C."),
        Claim(where, "with A and C in kg m²: tilt at the end of the figure's rocking", np.pi / 6, "rad",
              float(literal.tilt[-1]), 0.1,
              f"With these numbers the can does not rock: {literal.message}. The limits would be "
              f"{_limit(literal.body, NoSlip()):.2f}° and {_limit(literal.body, Frictionless()):.2f}°.",
              digits=4),
        Claim(where, "g", 9.8, "m/s²", GRAVITY, 0.05, is_input=True),
    ]  # fmt: skip


def _caption_taken_literally() -> Motion:
    body = Body(CAN.mass, CAN.radius, CAN.height, 5.1e-3, 8e-3)
    return simulate(body, start(), NoSlip(), 10.0, gravity=GRAVITY, topple_tilt=1.5)


def simulated_motion() -> list[Claim]:
    """The text's claims about the simulated motions."""
    where = "Dynamics"
    claims = []
    for law in LAWS:
        rocking = motion(law, duration=15.0)
        name = law.name.replace("_", " ")
        low = rocking.evaluate(rocking.turns[0].t)
        claims += [
            Claim(where, f"rocks “ad infinitum, without losing any energy” ({name}): relative change of "
                  f"energy over {len(rocking.turns)} rockings", 0.0, "",
                  float(np.ptp(rocking.energy) / rocking.energy[0]), 1e-10, digits=-1),
            Claim(where, f"near the table θ̇ ≈ −ψ̇ ({name}): θ̇/ψ̇ at the smallest tilt", -1.0, "",
                  float(low.spin_rate[0] / low.yaw_rate[0]), 1e-3, digits=7),
        ]  # fmt: skip
    ratio = float(np.max(motion(NoSlip()).samples(4).friction_ratio))
    claims.append(
        Claim(where, "“only a finite coefficient of friction is required”: our closed form "
              "mHR/(A+mH²), and the largest ratio in the simulation", closed_forms.needed_friction(CAN), "",
              ratio, 0.005, "The paper gives no number.", digits=4)
    )  # fmt: skip
    return claims


def all_claims() -> dict[str, list[Claim]]:
    """Every claim, by topic, in the order of the report."""
    return {
        "The can’s angle of turn": angles_of_the_can(),
        "Disks, rings and tall containers": disks_and_rings(),
        "The simulated motion": simulated_motion(),
        "The can and its parameters": parameters(),
        "The experiment (measured; nothing to compute)": experiment(),
    }
