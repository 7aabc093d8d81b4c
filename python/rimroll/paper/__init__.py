"""The paper, reproduced: every number, figure and erratum beside what rimroll computes.

`setting`: its can, start and motions. `claims`, `errata`, `figures`: what it says, and ours.
`report`: all of it as one page.
"""
