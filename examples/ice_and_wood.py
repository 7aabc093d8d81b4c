"""Does a can turn further on ice or on wood?

A can that falls upright does not slap the table: its contact point runs round the rim, by 221° if
the table has no friction and by 202° if the rim does not slip. Real tables lie between.

    no friction  220.97
    ice          219.49
    wood         204.55
    rubber       202.29
    no slip      202.29
"""

import numpy as np

import rimroll as rr

can = rr.bodies.can_2007()
tables = {
    "no friction": rr.Frictionless(),
    "ice": rr.surfaces.ice(),
    "wood": rr.surfaces.wood(),
    "rubber": rr.surfaces.rubber(),
    "no slip": rr.NoSlip(),
}
for name, law in tables.items():
    print(f"{name:12} {np.degrees(rr.turn_limit(can, law)):.2f}")
