"""The paper's errata: what is printed, what is right, and the test that proves it.

Each is verified by computer algebra from Newton's and Euler's laws alone, or by integrating the
printed equations, in ``tests/proofs/test_newton_euler.py``; ``test`` is the name of the
test there.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Erratum:
    """One misprint; formulas as HTML text."""

    where: str
    printed: str
    right: str
    verified: str
    test: str
    changes_a_result: bool = False


ERRATA = (
    Erratum(
        "Eq. (15), last two lines",
        "Δψ = π√((A+mH²)/(A+mR²+mH²)), which is 160.17° for the can",
        "<b>Δψ = π√((A+mR²+mH²)/(A+mH²))</b>, 202.29°, as in the paper’s own text and the line before",
        "ψ̇ = b₂/φ² integrated symbolically over all time, and the printed equations of motion "
        "integrated at ε = 10⁻⁴.",
        "test_erratum_inverted_fraction",
        changes_a_result=True,
    ),
    Erratum(
        "Simulation figure, caption",
        "A = 5.1×10⁻³, C = 8×10⁻³ “in consistent SI units”",
        "both are per unit mass, in m²",
        "In kg m², the can would topple from the printed start (φ = 1.5 rad at 2.129 s) and the limits would be "
        "182.99° and 183.18°; per unit mass, it rocks as the figure shows.",
        "test_erratum_inertias_are_per_unit_mass",
        changes_a_result=True,
    ),
    Erratum(
        "Simulation figure, caption",
        "C/m = 8×10⁻³ m²",
        "C/m ≤ R² = 2.601×10⁻³ m² for anything no wider than its rim; wall and disks have 1.3 to 2.2",
        "C/m is the mean square distance from the axis.",
        "test_erratum_axial_inertia_is_impossible_for_a_can_no_wider_than_its_rim",
        changes_a_result=True,
    ),
    Erratum(
        "Integral for Δψ",
        "from t<sub>c</sub>+Δt to t<sub>c</sub>−Δt",
        "from t<sub>c</sub>−Δt to t<sub>c</sub>+Δt",
        "The antiderivative: the printed limits give minus the next line.",
        "test_erratum_flipped_integration_limits",
    ),
    Erratum(
        "Eq. (5)",
        "C θ̇ φ",
        "C θ̇ φ̇",
        "Leading order of the exact first row at small tilt.",
        "test_erratum_missing_dot_on_phi_at_small_tilt",
    ),
    Erratum(
        "Eq. (7)",
        "ψ̇ + θ̇ = 0 is equivalent to the two equations before",
        "it is their solution with spin s = 0 only; “independent of initial conditions” needs s → 0 "
        "(no slip, H &gt; 0)",
        "The general solution of both rows; with a finite spin the turn is "
        "√(J/K)[π + 2 arctan(mHRs/(ω√(JK)))].",
        "test_erratum_yaw_plus_spin_zero_is_only_one_solution",
    ),
    Erratum(
        "Contact point",
        "x<sub>G</sub> − R cosφ cosψ + H sinφ, …",
        "(x<sub>G</sub>, y<sub>G</sub>) − (R cosφ − H sinφ)(cosψ, sinψ); "
        "z<sub>G</sub> = R sinφ + H cosφ",
        "The print composes the rotations in the wrong order, and its point is not at the table’s height.",
        "test_erratum_contact_point",
    ),
    Erratum(
        "Contact point at small tilt",
        "x<sub>P</sub> ≈ x<sub>G</sub> − R cosψ, …, “when … ψ is not particularly close to any multiple of π/2”",
        "at every ψ",
        "The right contact point is this circle times 1 − φH/R + O(φ²), whatever ψ; with the misprint "
        "above, H sinφ would exceed R cosψ near odd multiples of π/2.",
        "test_erratum_contact_circle_needs_no_condition_on_the_yaw",
    ),
    Erratum(
        "Appendix A, text",
        "Ω × v<sub>G</sub> from the rotation of the frame",
        "Ω₂ × v<sub>G</sub>; the printed acceleration itself is right",
        "The printed a<sub>G</sub> equals the derivative with Ω₂, not with Ω.",
        "test_erratum_omega_2_turns_the_frame_of_the_velocity",
    ),
    Erratum(
        "Appendix B, both energies",
        "2E = … + P.E.",
        "2E = … + 2 P.E.",
        "Only then is the energy constant along the printed equations.",
        "test_erratum_halved_potential_energy",
    ),
    Erratum(
        "Appendix B, frictionless energy",
        "C(θ̇ + ψ cosφ)²",
        "C(θ̇ + ψ̇ cosφ)²",
        "The print is not conserved, and depends on where ψ = 0 is.",
        "test_erratum_missing_dot_on_psi_in_the_frictionless_energy",
    ),
    Erratum(
        "Appendix B, first sentence",
        "b₂ = O(φ<sub>c</sub>²)",
        "b₂ = O(φ<sub>c</sub>), as at the end of the same paragraph; exactly ± φ<sub>c</sub> ω √(J′/K′)",
        "Energy at the smallest tilt; the measured exponent is 1 within 10⁻³.",
        "test_erratum_b_2_is_of_order_phi_c",
    ),
    Erratum(
        "Appendix B",
        "ψ̇ + θ̇ ~ ψ̇ φ",
        "ψ̇ + θ̇ = O(φ<sub>c</sub> ln φ<sub>c</sub>), smaller by that factor",
        "A symbolic limit, and the slope measured on computed motions.",
        "test_erratum_yaw_plus_spin_is_of_order_phi_c_log_phi_c",
    ),
    Erratum(
        "Heuristic treatment, no slip",
        "M<sub>G</sub> without the mass",
        "every term times m",
        "r × m a at leading order.",
        "test_erratum_heuristic_moment_lacks_the_mass",
    ),
    Erratum(
        "Heuristic treatment, no slip",
        "−H² along e<sub>x1</sub>, −RH along e<sub>z</sub>",
        "+H², +RH",
        "r × m a at leading order.",
        "test_erratum_heuristic_moment_has_two_signs_wrong",
    ),
    Erratum(
        "Heuristic treatment, frictionless",
        "−M R² φ̈",
        "−m R² φ̈",
        "r × m a at leading order.",
        "test_erratum_heuristic_capital_m_is_the_mass",
    ),
    Erratum(
        "Heuristic treatment",
        "tilt about +e<sub>y1</sub>",
        "the rest of the paper tilts about −e<sub>y1</sub>; the section flips the sign silently",
        "Half a turn of yaw maps one to the other, so no turn changes.",
        "test_erratum_heuristic_section_flips_the_sign_of_the_tilt",
    ),
    Erratum(
        "Disks",
        "“about 41 degrees more”",
        "42.49°",
        "√5 was cut to 2.23 before subtracting.",
        "test_erratum_homogeneous_disk_turns_42_degrees_more_than_once",
    ),
    Erratum(
        "Quantitative comparisons",
        "“about 220”, “40”",
        "220.97°, 40.97°",
        "The closed form.",
        "test_erratum_frictionless_can_turns_221_degrees",
    ),
)
