"""Filmed tracks: ``rimroll.filmed`` has the public names."""
