"""The paper, reproduced: its numbers, figures and errata beside rimroll's results.

`setting`: its can, start and motions. `claims`, `errata`, `figures`: what it says, and ours.
`report`: all of it as one page.
"""
