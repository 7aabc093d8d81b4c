"""The friction of a table from directions of fall.

`table` reads files and `angles` the directions in them; `summary` makes stand-ins for directions
of which only means and spreads are known. `predicted` computes how directions scatter at each
friction, `log_densities` interpolates that, `likelihood` compares the data with it, `verdict` says
what they exclude, `fit` puts it together and `figure` draws it.
"""

from rimroll.experiment.fitting.angles import read_directions
from rimroll.experiment.fitting.fit import Fit, fit
from rimroll.experiment.fitting.predicted import Predicted, predict_falls
from rimroll.experiment.fitting.summary import directions_from_summary

__all__ = ["Fit", "Predicted", "directions_from_summary", "fit", "predict_falls", "read_directions"]
