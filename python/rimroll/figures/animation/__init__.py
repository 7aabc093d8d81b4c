"""Films of a motion: GIF, a page with controls, or MP4, slowed where the contact point runs.

`clock` computes film time, `stage` arranges what the film shows, `painter` paints it, `files`
and `film_file` write it, and `film` keeps it in memory. `shaken_stage` shows a table that moves:
its plate is in `moving_table`, the record below in `strip`.
"""

from rimroll.figures.animation.film import Film, animate

__all__ = ["Film", "animate"]
