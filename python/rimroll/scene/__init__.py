"""What is visible of a body of revolution on the rim of its base: shapes, places, colours.

Shapes are given as a camera sees them, in metres in the picture. The body is a mesh of flat facets
with brightness by Lambert's law. Facets are painted from far to near, except those that face away.
What lies on the table (shadow, trail, wedge) is painted before the body, which always hides it.
:mod:`rimroll.artists` draws all this in vectors on matplotlib axes, :mod:`rimroll.animation` paints
it in pixels.
"""

from rimroll.scene.camera import Camera
from rimroll.scene.palette import (
    ARC_WIDTH,
    BLUE,
    CONTACT_EDGE,
    CONTACT_SIZE,
    GREEN,
    HIDDEN_CONTACT,
    HIDDEN_RIM,
    INK,
    ORANGE,
    RIM,
    RIM_WIDTH,
    SHADE,
    SHADOW,
    TABLE,
    VERMILLION,
    WEDGE,
    rgb,
)
from rimroll.scene.pose import Array, Event, Motion, Pose, RoundBody, States, contact_path, pose_at
from rimroll.scene.shape import Mesh, Profile, mesh
from rimroll.scene.table import (
    Wedge,
    cast_shadow,
    label_offset,
    on_table,
    shadow_layers,
    table_rings,
    way_in_picture,
    wedge,
)
from rimroll.scene.visible import contact_seen, rim_stretches, visible_facets

__all__ = [
    "ARC_WIDTH",
    "BLUE",
    "CONTACT_EDGE",
    "CONTACT_SIZE",
    "GREEN",
    "HIDDEN_CONTACT",
    "HIDDEN_RIM",
    "INK",
    "ORANGE",
    "RIM",
    "RIM_WIDTH",
    "SHADE",
    "SHADOW",
    "TABLE",
    "VERMILLION",
    "WEDGE",
    "Array",
    "Camera",
    "Event",
    "Mesh",
    "Motion",
    "Pose",
    "Profile",
    "RoundBody",
    "States",
    "Wedge",
    "cast_shadow",
    "contact_path",
    "contact_seen",
    "label_offset",
    "mesh",
    "on_table",
    "pose_at",
    "rgb",
    "rim_stretches",
    "shadow_layers",
    "table_rings",
    "visible_facets",
    "way_in_picture",
    "wedge",
]
