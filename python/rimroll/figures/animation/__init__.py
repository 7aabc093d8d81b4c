"""Films of a motion: GIF, a page with controls, or MP4, slowed where the contact point runs.

`clock` computes film time, `stage` arranges what the film shows, also of a table that moves,
`painter` paints it, and `film` keeps it in memory or writes it.
"""

from rimroll.figures.animation.film import Film, animate

__all__ = ["Film", "animate"]
