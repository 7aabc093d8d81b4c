"""Bodies on a base with corners, and their motions.

:class:`rimroll.PolygonalBody` and the presets of :mod:`rimroll.polygons` make the bodies;
:func:`rimroll.simulate` follows them.
"""

from rimroll.polygon.body import PolygonalBody
from rimroll.polygon.motion import PolygonEvent, PolygonMotion

__all__ = ["PolygonEvent", "PolygonMotion", "PolygonalBody"]
