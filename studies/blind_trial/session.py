"""One measurement session: the readings in the order taken, with the recorded conditions of each."""
from dataclasses import dataclass

import numpy as np


@dataclass
class Session:
    """N readings. q holds the encoder angles; the true angles are q plus the errors that effects add."""
    q: np.ndarray             # (N, J): encoder angles [rad]
    load: np.ndarray          # (N,): load at the tip [lbf]
    direction: np.ndarray     # (N, J), -1 or +1: direction of each joint's last motion
    temperature: np.ndarray   # (N,): temperature [degF]
    time: np.ndarray          # (N,): time since the start of the session [min]

    @property
    def elapsed(self):
        """Fraction of the session elapsed at each reading, 0 to 1."""
        return self.time / self.time[-1]


def draw_session(q, load, rng):
    """Returns readings about two minutes apart in a hall that warms or cools by 8 to 28 degF, with random directions of
    motion."""
    count = len(q)
    time = np.concatenate([[0.], np.cumsum(rng.uniform(1., 3., count - 1))]).round(1)
    phase, swing = rng.uniform(-.5, .3) * np.pi, rng.uniform(.6, 1.2) * np.pi
    wave = rng.uniform(8., 28.) * np.sin(phase + swing * time / time[-1])
    temperature = rng.uniform(58., 70.) + wave + rng.normal(0., .5, count)
    direction = rng.choice([-1, 1], (count, q.shape[1]))
    return Session(q, np.asarray(load, float), direction, temperature.round(1), time)
