"""Parameters that several laws have."""

from __future__ import annotations

from rimroll.laws.parameters import Parameter

FRICTION = Parameter(help="Friction over normal force while the rim slides.")
STATIC = Parameter(
    option="static_friction",
    help="Largest friction over normal force while the rim sticks. [as --friction]",
)
RESTITUTION = Parameter(help="Restitution of landings, 0 to 1; not for no-slip. [0]")
