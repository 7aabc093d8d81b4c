"""``rimroll score``: the command of the package rimroll-score, if that is installed."""

from rimroll.errors import RimrollError

try:
    from rimroll_score.command import score as score
except ModuleNotFoundError as error:
    if error.name != "rimroll_score":
        raise
    message = (
        "rimroll score needs another package: pip install rimroll-score, or ./score from a clone"
    )
    raise RimrollError(message) from None
