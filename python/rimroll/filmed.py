"""Filmed tracks of a body: their files, and the motions that are fitted to them."""

from __future__ import annotations

from rimroll.sensors.filmed.track import Track, read
from rimroll.sensors.filmed.track_fit import fit_track
from rimroll.sensors.filmed.track_result import TrackFit

__all__ = ["Track", "TrackFit", "fit_track", "read"]
