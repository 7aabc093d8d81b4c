"""How does the turn depend on tilt and friction, as a table?

Named axes make a grid of starts and laws. The result is a dataset of xarray, and one call makes it
a table of pandas: turns in degrees, tilts in rows, frictions in columns.

    friction   0.05   0.10   0.20   0.40
    tilt
    10        221.2  220.6  216.4  202.5
    20        221.2  219.7  211.2  202.5
    30        220.4  216.6  210.1  202.7
    the turn falls fastest before friction 0.4
"""

import numpy as np

import rimroll as rr

can = rr.bodies.can_2007()
tilt = rr.axis("tilt", [10, 20, 30], units="deg")
friction = rr.axis("friction", [0.05, 0.1, 0.2, 0.4])
falls = rr.ensemble(can, rr.State(tilt=tilt, yaw_rate=0.005), rr.Coulomb(friction))
table = np.degrees(falls.turn).round(1).to_pandas()
print(table)
print("the turn falls fastest before friction", table.diff(axis=1).min().idxmin())
