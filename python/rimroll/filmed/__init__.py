"""Filmed tracks of a body: their files, and the motions that are fitted to them."""

from rimroll.filmed.files import read
from rimroll.filmed.fit import fit_track
from rimroll.filmed.result import TrackFit
from rimroll.filmed.track import Track

__all__ = ["Track", "TrackFit", "fit_track", "read"]
