"""The paper, reproduced: every number, figure and erratum beside what rimroll computes."""

from rimroll.paper.report import reproduce

__all__ = ["reproduce"]
