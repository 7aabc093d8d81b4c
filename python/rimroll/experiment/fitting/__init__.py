"""The friction of a table from directions of fall.

`angles` reads them, `predicted` computes how they scatter at each friction, `likelihood` holds them
against that, `verdict` says what they exclude, `fit` puts it together and `figure` draws it.
"""

from rimroll.experiment.fitting.angles import directions_of_summary, read_angles
from rimroll.experiment.fitting.fit import Fit, fit
from rimroll.experiment.fitting.predicted import Predicted, predict_falls

__all__ = ["Fit", "Predicted", "directions_of_summary", "fit", "predict_falls", "read_angles"]
