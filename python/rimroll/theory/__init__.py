"""The theory in numbers: closed forms, approximations, exact turns, steady motions, decay."""
