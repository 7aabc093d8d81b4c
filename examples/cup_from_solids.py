"""How does a cup of one's own rock, empty and full?

Only five numbers of a body enter its motion. Coaxial solids make them: a wall, a bottom, and coffee
that moves with the cup like a solid. The cup stands on a rim of 3 cm.

    empty 150 g, centre of mass at 3.60 cm
          balances at 39.8 deg, turns 207.7 deg, needs friction 0.40
    full  404 g, centre of mass at 3.54 cm
          balances at 40.3 deg, turns 213.5 deg, needs friction 0.48
"""

import numpy as np

import rimroll as rr

empty = [
    rr.solids.wall(mass="120 g", radius="3.5 cm", length="9 cm"),
    rr.solids.disk(mass="30 g", radius="3.5 cm"),
]
coffee = rr.solids.filling(density=1000, radius="3.4 cm", depth="7 cm")
for name, solids in {"empty": empty, "full": [*empty, coffee]}.items():
    cup = rr.Body.from_solids(radius="3 cm", solids=solids)
    turn, balance = np.degrees([rr.turn_limit(cup, rr.NoSlip()), rr.balance_tilt(cup)])
    needed = rr.needed_friction(cup)
    print(f"{name:5} {1e3 * cup.mass:3.0f} g, centre of mass at {1e2 * cup.height:.2f} cm")
    print(f"      balances at {balance:.1f} deg, turns {turn:.1f} deg, needs friction {needed:.2f}")
