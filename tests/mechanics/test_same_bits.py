"""A motion has the same bits in every process and thread."""

import subprocess
import sys

from given.motions import bits, by_law, paper_motion, same_bits


@by_law
def test_a_motion_computed_twice_has_the_same_bits(law):
    assert same_bits(paper_motion(law), paper_motion(law))


SAME_MOTION = """
import hashlib, sys
import numpy as np, rimroll as rr
from rimroll import laws, motion
start = rr.State(tilt=np.pi / 6, tilt_rate=-0.5, yaw_rate=0.005, spin_rate=0.005)
again = rr.simulate(rr.bodies.can_2007(), start, laws.by_name(sys.argv[1]), gravity=9.8)
print(hashlib.sha256(b"".join(again[name].tobytes() for name in motion.UNITS)).hexdigest())
"""


@by_law
def test_another_process_computes_the_same_bits(law):
    run = subprocess.run(
        [sys.executable, "-c", SAME_MOTION, law.name], capture_output=True, text=True
    )
    assert run.stdout.strip() == bits(paper_motion(law)), run.stderr
