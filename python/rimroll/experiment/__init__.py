"""The paper's experiment, on a computer and on a table.

`release`: how a hand lets go. `toppling`: one flick after another. `histogram`: where the body
fell. `readings`, `measurement`: the body from kitchen measurements. `protractor`: a sheet to read
its falls on. `directions`: those that were read, from files. `fit`: the friction of the table from
them; `predicted` computes how directions scatter at each friction, and `likelihood` compares the
data with that.
"""
