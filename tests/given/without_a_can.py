"""Records of gyroscopes that were never in a can: hands, steps, cars, throws, turntables, noise."""

import numpy as np

import rimroll as rr

KINDS = (
    *("band", "burst", "walk", "drive", "hand", "thrown"),
    *("dropped", "noise", "turntable", "pendulum"),
)


def _band(draw, count, rate, low, high):
    """Random rates of unit size between two frequencies in Hz, (count, 3)."""
    at = np.fft.rfftfreq(count, 1.0 / rate)
    inside = ((at >= low) & (at <= high))[:, np.newaxis]
    waves = draw.normal(size=(len(at), 3)) + 1j * draw.normal(size=(len(at), 3))
    rates = np.fft.irfft(inside * waves, count, axis=0)
    return rates / rates.std()


def _tumbling(draw, t, size):
    """A box that flies for up to a second by Euler's equations, and then bounces, rad/s."""
    moments = np.array([1.0, draw.uniform(1.5, 4.0), 0.0])
    moments[2] = 0.95 * (moments[0] + moments[1])
    start, flight = draw.uniform(1.5, 3.0), draw.uniform(0.3, 1.0)
    rates, turning, step = np.zeros((len(t), 3)), draw.normal(0.0, size, 3), 0.1 * (t[1] - t[0])
    knocks = draw.normal(0.0, 8.0, (9, 3)) * 0.5 ** np.arange(9)[:, np.newaxis]
    for i, since in enumerate(t - start):
        if 0.0 <= since < flight:
            for _ in range(10):
                turning = turning - step * np.cross(turning, moments * turning) / moments
            rates[i] = turning
        elif flight <= since < flight + 1.5:
            bounce, after = divmod(since - flight, 0.18)
            rates[i] = knocks[int(bounce)] * np.exp(-after / 0.08)
    return rates


def _rates(kind, draw, t, rate):
    count = len(t)
    if kind in ("band", "burst"):
        low = draw.uniform(0.0, 2.0)
        rates = _band(draw, count, rate, low, low + draw.uniform(0.5, 20.0))
        rates *= draw.uniform(0.5, 6.0) * draw.uniform(0.2, 1.0, 3)
        begin = t[-1] * draw.uniform(0.1, 0.5)
        return (
            rates * (0.5 + 0.5 * np.tanh(10.0 * (t - begin)))[:, None] if kind == "burst" else rates
        )
    if kind == "walk":
        pace = draw.uniform(0.8, 1.3)
        waves = [np.sin(2.0 * np.pi * k * pace * t + draw.uniform(0.0, 6.0)) for k in range(1, 9)]
        steps = [np.outer(wave, draw.normal(0.0, 1.5 / (1 + k), 3)) for k, wave in enumerate(waves)]
        return sum(steps) + 0.2 * _band(draw, count, rate, 0.0, 15.0)
    if kind == "drive":
        shaking = draw.uniform(0.01, 0.5) * _band(draw, count, rate, 5.0, 20.0)
        return 0.3 * _band(draw, count, rate, 0.0, 0.5) + shaking
    if kind == "hand":
        bumps = [
            np.exp(-(((t - draw.uniform(1.0, t[-1])) / draw.uniform(0.05, 0.5)) ** 2))
            for _ in range(12)
        ]
        return sum(np.outer(bump, draw.normal(0.0, 3.0, 3)) for bump in bumps)
    if kind in ("thrown", "dropped"):
        return _tumbling(draw, t, 4.0 if kind == "thrown" else 0.7)
    if kind == "noise":
        return draw.normal(0.0, draw.uniform(0.3, 5.0), (count, 3))
    if kind == "turntable":
        return np.outer(draw.uniform(2.0, 8.0) * np.clip(t - 2.0, 0.0, 1.0), draw.normal(size=3))
    swing = np.sin(2.0 * np.pi * draw.uniform(0.5, 2.0) * np.maximum(t - 2.0, 0.0))
    along = draw.normal(size=3)
    return np.outer(
        draw.uniform(1.0, 5.0) * swing * np.exp(-0.1 * t), along / np.linalg.norm(along)
    )


def without_a_can(seed):
    """A record of a kind that follows from the seed, 8 to 16 s long."""
    draw = np.random.default_rng(seed)
    rate = float(draw.choice([50, 100, 200]))
    t = np.arange(int(rate * draw.uniform(8.0, 16.0))) / rate
    rates = _rates(KINDS[seed % len(KINDS)], draw, t, rate) + draw.normal(0.0, 1e-3, (len(t), 3))
    return rr.gyro.Record(t, rates, KINDS[seed % len(KINDS)])
