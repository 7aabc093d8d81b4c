"""Records from filtered noise."""

from __future__ import annotations

from rimroll import _core
from rimroll.errors import RimrollError, hold
from rimroll.given import Number, Values, numbers, positive, random_seed
from rimroll.ground.ground import Ground
from rimroll.ground.lines import MAX_POINTS


def synthetic(
    seed: int,
    amplitude: Values = 3.0,
    *,
    duration: Number = 20.0,
    step: Number = 0.01,
    soil_period: Number = 0.4,
    soil_damping: Number = 0.6,
) -> Ground:
    """A synthetic record, which resembles an earthquake and is none.

    Gaussian white noise, independent in each component, under an envelope that rises as t² in the
    first tenth of the duration, is constant for three tenths and then decays exponentially to 5 %
    (Jennings), passes the filter of Kanai and Tajimi, a layer of soil on rock, and the high-pass
    filter of Clough and Penzien, which removes drift. Each component is scaled to its peak.

    Raises ``RimrollError`` for numbers that are not positive (an amplitude may be 0), and for fewer
    than 100 samples or more than ten million.

    Parameters
    ----------
    seed
        A whole number; the same seed gives the same record, to the last bit, on every machine.
    amplitude
        The peak, m/s²: a number, along x alone, or three (x, y, z).
    duration, step
        Length of the record and time between two samples, s.
    soil_period, soil_damping
        Natural period (s) and damping ratio of the soil; firm soil has 0.4 s and 0.6.

    Examples
    --------
    >>> import rimroll as rr
    >>> rr.ground.synthetic(1, amplitude=("0.3 g", "0.3 g", "0.2 g"))
    <Ground of 2001 samples at 0.01 s: 20 s, peaks 2.942, 2.942, 1.961 m/s²>
    """
    peaks = numbers("amplitude", amplitude, "m/s^2")
    if peaks.shape not in ((), (3,)):
        raise RimrollError(
            field="amplitude", value=amplitude, bound="one number or three (x, y, z)"
        )
    hold("amplitude", peaks, (peaks >= 0.0) & (peaks <= 1e9), "between 0 and 1e9", "m/s^2")
    end, interval = positive("duration", duration, "s"), positive("step", step, "s")
    count = round(end / interval) if end / interval < 1e9 else MAX_POINTS
    if not 100 <= count + 1 <= MAX_POINTS:
        raise RimrollError(
            f"duration/step must be between 100 and {MAX_POINTS}, got {end / interval:g}"
        )
    soil = positive("soil_period", soil_period, "s"), positive("soil_damping", soil_damping)
    wanted = peaks.tolist() if peaks.ndim else [float(peaks), 0.0, 0.0]
    return Ground(_core.CoreGround.synthetic(random_seed(seed), wanted, interval, count + 1, *soil))
