"""The public names and the modules that they come from: their one list, also at run time."""

from rimroll import filmed as filmed, ground as ground, gyro as gyro
from rimroll import bodies as bodies
from rimroll.bodies import polygons as polygons
from rimroll.bodies import solids as solids
from rimroll.laws import surfaces as surfaces
from rimroll._core import STANDARD_GRAVITY as STANDARD_GRAVITY, __version__ as __version__
from rimroll.theory.approximations import (
    Composite as Composite,
    NearCollision as NearCollision,
    composite as composite,
    pasted as pasted,
)
from rimroll.bodies.body import Body as Body
from rimroll.browser.view import Lab as Lab, lab as lab
from rimroll.theory.decays import Decay as Decay, decay as decay
from rimroll.errors import RimrollError as RimrollError
from rimroll.theory.exact import ExactTurn as ExactTurn, exact_turn as exact_turn
from rimroll.experiment.directions import read_directions as read_directions
from rimroll.experiment.fit import Fit as Fit, fit as fit
from rimroll.experiment.predicted import (
    Predicted as Predicted,
    predict_falls as predict_falls,
)
from rimroll.experiment.directions import (
    directions_from_summary as directions_from_summary,
)
from rimroll.experiment.measurement import Measurement as Measurement, measure as measure
from rimroll.experiment.release import Release as Release
from rimroll.experiment.toppling import topple as topple
from rimroll.theory.decays import EndExponent as EndExponent, fit_exponent as fit_exponent
from rimroll.many.falls import Interrupted as Interrupted
from rimroll.many.grid import axis as axis
from rimroll.ground.ground import Ground as Ground
from rimroll.sensors.gyro.motion_fit import fit_motion as fit_motion
from rimroll.sensors.gyro.motion_result import MotionFit as MotionFit
from rimroll.theory.imperfection import (
    Collision as Collision,
    ImperfectRim as ImperfectRim,
    imperfect_rim as imperfect_rim,
)
from rimroll.laws import (
    AirDrag as AirDrag,
    Coulomb as Coulomb,
    Frictionless as Frictionless,
    InPlace as InPlace,
    Law as Law,
    NoSlip as NoSlip,
    PivotingFriction as PivotingFriction,
    RollingResistance as RollingResistance,
    Stribeck as Stribeck,
    Tabulated as Tabulated,
    Viscous as Viscous,
)
from rimroll.many.ensemble import ensemble as ensemble
from rimroll.motion import (
    Event as Event,
    Moments as Moments,
    Motion as Motion,
    Phase as Phase,
    Stats as Stats,
    Turn as Turn,
    Validity as Validity,
    simulate as simulate,
)
from rimroll.motion.jacobian import Jacobian as Jacobian
from rimroll.theory.nutations import (
    Nutation as Nutation,
    nutation as nutation,
    resonant_start as resonant_start,
)
from rimroll.options import Options as Options
from rimroll.bodies.polygons import PolygonalBody as PolygonalBody
from rimroll.motion.polygons import PolygonEvent as PolygonEvent, PolygonMotion as PolygonMotion
from rimroll.theory.reduced import (
    ReducedMotion as ReducedMotion,
    reduced_motion as reduced_motion,
    rocking_friction as rocking_friction,
)
from rimroll.many.left_or_right import (
    turn_map as turn_map,
    watershed as watershed,
    watershed_slope as watershed_slope,
)
from rimroll.shaking.lognormal import (
    Fragility as Fragility,
    UndecidedWarning as UndecidedWarning,
    fragility as fragility,
)
from rimroll.shaking.many import shake_many as shake_many
from rimroll.shaking.maxima import (
    Distance as Distance,
    Maxima as Maxima,
    imperfect_starts as imperfect_starts,
    random_maxima as random_maxima,
)
from rimroll.shaking.overturning import (
    OverturningSpectrum as OverturningSpectrum,
    overturning_scale as overturning_scale,
    overturning_spectrum as overturning_spectrum,
)
from rimroll.shaking.rocking import (
    RockingSpectrum as RockingSpectrum,
    rocking_spectrum as rocking_spectrum,
)
from rimroll.shaking.scales import rocking_frequency as rocking_frequency
from rimroll.bodies.solids import Solid as Solid
from rimroll.theory.steady import growth_rates as growth_rates
from rimroll.state import State as State
from rimroll.theory.steady import (
    SteadyMotion as SteadyMotion,
    critical_rolling_spin as critical_rolling_spin,
    critical_spinning_rate as critical_spinning_rate,
    nutation_ratio as nutation_ratio,
    spinning_rate as spinning_rate,
    steady_motions as steady_motions,
    steady_wobble_rate as steady_wobble_rate,
)
from rimroll.study.study import Study as Study
from rimroll.theory.closed_forms import (
    Arrival as Arrival,
    Passage as Passage,
    arrival as arrival,
    balance_tilt as balance_tilt,
    disk_turn_limit as disk_turn_limit,
    error_law_coefficient as error_law_coefficient,
    lift_off_rate as lift_off_rate,
    needed_friction as needed_friction,
    painleve_friction as painleve_friction,
    passage as passage,
    point_mass_turn_limit as point_mass_turn_limit,
    slip_rate as slip_rate,
    tall_turn_limit as tall_turn_limit,
    turn_limit as turn_limit,
    turn_limit_with_spin as turn_limit_with_spin,
)
