"""How round things fall, rock and roll on the rim of their base.

>>> import numpy as np, rimroll as rr
>>> can = rr.bodies.can_2007()
>>> start = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
>>> motion = rr.simulate(can, start, rr.NoSlip(), duration=2.0, gravity=9.8)
>>> round(float(np.degrees(motion.turns[1].angle)), 3)
202.675
>>> round(float(np.degrees(rr.turn_limit(can, rr.NoSlip()))), 3)
202.287

Plain numbers are in SI units and radians throughout; texts such as ``"30 deg"`` and quantities of
pint are converted (see :mod:`rimroll.given`). Source of the mechanics:
M. Srinivasan and A. Ruina, *Rocking and rolling: a can that appears to rock might actually roll*
(2007), called "the paper" below.
"""

from rimroll import bodies, solids, surfaces
from rimroll._core import STANDARD_GRAVITY, __version__
from rimroll.approximations import NearCollision, Pasted, pasted
from rimroll.body import Body
from rimroll.ensemble import ensemble
from rimroll.errors import RimrollError
from rimroll.exact import ExactTurn, exact_turn
from rimroll.experiment.fitting import (
    Fit,
    Predicted,
    directions_of_summary,
    fit,
    predict_falls,
    read_angles,
)
from rimroll.experiment.measurement import Measurement, measure
from rimroll.experiment.release import Release
from rimroll.experiment.toppling import topple
from rimroll.falls import Interrupted
from rimroll.grid import axis
from rimroll.imperfection import Collision, ImperfectRim, imperfect_rim
from rimroll.jacobian import Jacobian
from rimroll.laws import (
    AirDrag,
    Coulomb,
    Frictionless,
    Law,
    NoSlip,
    PivotingFriction,
    RollingResistance,
    Stribeck,
    Tabulated,
    Viscous,
)
from rimroll.motion import Event, Moments, Motion, Phase, Stats, Turn, simulate
from rimroll.sensitivity import turn_map, watershed, watershed_slope
from rimroll.solids import Solid
from rimroll.state import State
from rimroll.theory import (
    Arrival,
    Passage,
    arrival,
    balance_tilt,
    disk_turn_limit,
    error_law_coefficient,
    lift_off_rate,
    needed_friction,
    painleve_friction,
    passage,
    point_mass_turn_limit,
    slip_rate,
    steady_wobble_rate,
    tall_turn_limit,
    turn_limit,
    turn_limit_with_spin,
)

__all__ = [
    "STANDARD_GRAVITY",
    "AirDrag",
    "Arrival",
    "Body",
    "Collision",
    "Coulomb",
    "Event",
    "ExactTurn",
    "Fit",
    "Frictionless",
    "ImperfectRim",
    "Interrupted",
    "Jacobian",
    "Law",
    "Measurement",
    "Moments",
    "Motion",
    "NearCollision",
    "NoSlip",
    "Passage",
    "Pasted",
    "Phase",
    "PivotingFriction",
    "Predicted",
    "Release",
    "RimrollError",
    "RollingResistance",
    "Solid",
    "State",
    "Stats",
    "Stribeck",
    "Tabulated",
    "Turn",
    "Viscous",
    "__version__",
    "arrival",
    "axis",
    "balance_tilt",
    "bodies",
    "directions_of_summary",
    "disk_turn_limit",
    "ensemble",
    "error_law_coefficient",
    "exact_turn",
    "fit",
    "imperfect_rim",
    "lift_off_rate",
    "measure",
    "needed_friction",
    "painleve_friction",
    "passage",
    "pasted",
    "point_mass_turn_limit",
    "predict_falls",
    "read_angles",
    "simulate",
    "slip_rate",
    "solids",
    "steady_wobble_rate",
    "surfaces",
    "tall_turn_limit",
    "topple",
    "turn_limit",
    "turn_limit_with_spin",
    "turn_map",
    "watershed",
    "watershed_slope",
]
