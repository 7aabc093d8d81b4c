"""How far a rigid body on a rigid, smooth table is a good model for a turn."""

from __future__ import annotations

from dataclasses import dataclass

from rimroll import _core

FINE, COARSE = _core.UNEVENNESS
"""How far rims and tables depart from a plane, m: the general tolerances H and L for the flatness
of faces between 30 and 100 mm across (ISO 2768-2)."""

SPEED_OF_SOUND: float = _core.SPEED_OF_SOUND
"""The speed of sound in the body, m/s: roughly that in steel, aluminium and glass."""


@dataclass(frozen=True)
class Validity:
    """Numbers of a turn to compare with a real body, and whether the model still describes them.

    The model is a rigid body with a perfect circle for a rim, on a rigid and smooth table, without
    air. Where a number is beyond it, do not trust the gap or the speed. The angle of turn hardly
    depends on how small the gap becomes.

    The forces count between impacts; that of an impact is infinite.
    """

    gap: float
    """Height of the highest point of the rim above its lowest at the smallest tilt, m."""
    contact_speed: float
    """Speed of the contact point along the rim then, m/s."""
    passage_time: float
    """Time from a tenth to nine tenths of the angle of turn, s."""
    sound_time: float
    """Time in which sound crosses the base, s."""
    force_ratio: float
    """Largest normal force over the weight. It acts at one point; at how many weights a rim yields
    depends on the weight, the material and the rounding of the edge."""
    loss_ratio: float
    """Energy lost over the largest kinetic energy."""
    is_uneven: bool
    """Whether the gap is smaller than coarse rims and tables are uneven, 0.4 mm."""
    is_faster_than_sound: bool
    """Whether the contact point runs faster along the rim than sound."""
    is_flexible: bool
    """Whether the passage is shorter than ten times that of sound: the body bends and rings."""
    is_lossless: bool
    """Whether less than 1 % of the energy is lost, which is less than in any real can."""

    def __str__(self) -> str:
        """The numbers with what they mean, a line each; the force has no limit."""
        table = (
            (
                self.is_uneven,
                f"the gap closes to {self.gap:.3g} m",
                f"a rim is flat within {FINE:g} to {COARSE:g} m",
            ),
            (
                self.is_faster_than_sound,
                f"the contact point runs at {self.contact_speed:.3g} m/s",
                f"sound runs at {SPEED_OF_SOUND:.0f} m/s",
            ),
            (
                self.is_flexible,
                f"most of the angle takes {self.passage_time:.3g} s",
                f"sound crosses the base in {self.sound_time:.3g} s",
            ),
            (
                self.is_lossless,
                f"the turn loses {100.0 * self.loss_ratio:.3g} % of the energy",
                "a real can loses 1 % or more",
            ),
        )
        lines = [
            f"{'beyond the model' if beyond else 'within the model'}: {here}; {limit}"
            for beyond, here, limit in table
        ]
        force = f"the largest force is {self.force_ratio:.3g} weights, at one point"
        return "\n".join([*lines, force])


def validity_of(core: _core.CoreMotion) -> list[Validity]:
    """How far the model holds in each turn of a motion."""
    return [Validity(*numbers, *exceeded) for numbers, exceeded in core.validity()]
