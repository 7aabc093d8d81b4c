//! The Python boundary of rimroll. It only converts numbers and arrays.

mod arguments;
mod bodies;
mod ensemble;
mod exact;
mod ground;
mod motion;
mod polygon;
mod shaking;
mod theory;
mod watched;

use pyo3::prelude::*;

/// The compiled part of the Python package, imported there as `rimroll._core`.
#[pymodule]
mod _core {
    use super::*;
    use rimroll::{FrictionLaw, motion as core};

    #[pymodule_export]
    use crate::bodies::{
        body_from_solids, check_body, check_solid, cylinder, disk, filling, first_bad_body,
        hollow_cylinder, preset, ring, wall,
    };
    #[pymodule_export]
    use crate::ensemble::{ensemble, first_refused};
    #[pymodule_export]
    use crate::exact::exact_turns;
    #[pymodule_export]
    use crate::ground::CoreGround;
    #[pymodule_export]
    use crate::motion::{CoreMotion, simulate};
    #[pymodule_export]
    use crate::polygon::{
        CorePolygonMotion, check_polygonal_body, housner_ratio, prism, simulate_polygonal_body,
    };
    #[pymodule_export]
    use crate::shaking::{first_refused_shaking, shake_many};
    #[pymodule_export]
    use crate::theory::{
        CoreComposite, CoreNearCollision, arrival, balance_tilt, check_contact_law,
        critical_rolling_spin, critical_spinning_rate, disk_turn_limit, error_law_coefficient,
        first_bad_contact_law, friction_at, imperfect_rim, lift_off_rate, needed_friction,
        nutation_ratio, painleve_friction, passage, point_mass_turn_limit, slip_rate,
        spinning_rate, steady_motions, steady_wobble_rate, tall_turn_limit, turn_limit,
        turn_limit_with_spin, watershed_slope,
    };

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("COLUMNS", core::COLUMNS)?;
        module.add("POLYGON_COLUMNS", rimroll::polygon::COLUMNS)?;
        module.add("PARAMETERS", core::PARAMETERS)?;
        module.add("SHAKEN_PARAMETERS", core::SHAKEN_PARAMETERS)?;
        module.add("EXACT_COLUMNS", crate::exact::EXACT_COLUMNS)?;
        module.add("FALL_COLUMNS", crate::ensemble::FALL_COLUMNS)?;
        module.add("SHAKEN_COLUMNS", crate::shaking::SHAKEN_COLUMNS)?;
        module.add("STATUSES", crate::shaking::statuses())?;
        module.add("OUTCOMES", core::Outcome::ALL.map(core::Outcome::name))?;
        module.add("LAWS", FrictionLaw::NAMES)?;
        module.add("MAX_FRICTION", rimroll::law::MAX_FRICTION)?;
        module.add("UNEVENNESS", <(f64, f64)>::from(core::UNEVENNESS))?;
        module.add("SPEED_OF_SOUND", core::SPEED_OF_SOUND)?;
        module.add("STANDARD_GRAVITY", core::STANDARD_GRAVITY)
    }
}
