"""A scorecard for physics engines: how right do they get a can that rocks on its rim?

:mod:`rimroll_score.protocol` is all that the author of an adapter needs. Nothing is loaded here,
so that the process in which an engine runs needs NumPy and the engine alone.
"""
