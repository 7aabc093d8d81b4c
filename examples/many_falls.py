"""Can anyone flick a can so that it falls straight away?

Ten thousand flicks by an unsteady hand. In each the contact point runs round the rim by more than
half a turn, so that the can falls left or right of straight away (180°). Rows are directions in
degrees; each # stands for a hundred falls.

    135-145
    145-155 #############
    155-165 #################################
    165-175 ###
    175-185
    185-195 ###
    195-205 #################################
    205-215 ##############
    215-225
    the nearest falls 2.9 degrees beside straight away
"""

import numpy as np

import rimroll as rr

can = rr.bodies.can_2007()
falls = rr.topple(can, rr.NoSlip(), n=10_000, release="paper", seed=1)
direction = np.degrees(falls.direction.values)
direction = direction[np.isfinite(direction)]
bins = np.arange(135, 226, 10)
counts, _ = np.histogram(direction, bins)
for low, count in zip(bins, counts, strict=False):
    print(f"{low}-{low + 10} {'#' * round(count / 100)}")
away = abs(direction - 180)
print(f"the nearest falls {away.min():.1f} degrees beside straight away")
