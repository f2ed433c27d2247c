"""System identification: motor parameters that reproduce a recording of joint targets and measured joint states.

The recorded joint targets are replayed in the simulator, and the motor parameters are fitted so that the simulated
joints match the measurements: a nonlinear least-squares fit. The first part of the recording is used for the
fit; the rest is held out to validate it.
"""

from quadruped_env.identification.fitted_parameters import FITTED, QUANTITIES
from quadruped_env.identification.identify import Identification, identify

__all__ = ["FITTED", "QUANTITIES", "Identification", "identify"]
