"""Late states, lost states, clock steps and suspended processes, at any time: the robot walks again within seconds."""

import functools
import math

import numpy as np
import pytest
from built_in import STANCE
from live_bench import EPOCH, KINDS, LEVEL, PERIOD, Bench, Disturbance, Link, Recording, measured

from quadruped_env import QuadrupedError
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.live_controller import LiveController, Measurement, Mode, Safety
from quadruped_env.control.timestamp_filter import TimestampFilter
from quadruped_env.live.simulated import TIMESTEP, SimulatedRobot
from quadruped_env.policies import find_controller

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

WALKS_WITHIN = 3.0
"""Maximum time from the end of a disturbance to walking, s. Simulated time: the machine's speed does not matter."""
GETS_UP = 6.5
"""Maximum time of getting up, s; up to 5 s of it are the stand-up trajectory."""
PHYSICAL = tuple(kind for kind in KINDS if kind != "lag")
"""Delays that are tested in physics: with a lag, states may be late permanently, and no policy walks on such states."""
TILTED = np.array([np.cos(0.6), np.sin(0.6), 0.0, 0.0])
BACKGROUND = (Disturbance("loss", 4.0, 0.6), Disturbance("loss", 6.5, 1.6), Disturbance("fall", 10.5, 0.7))
"""Brings the live controller through all modes: holding at 4.2 s, ramping, waiting limp from 7.5 to 8.3 s, lying."""


class StandingLink(Link):
    """A link to a robot that stays in its stance, and is laid on its side and put up again once."""

    def __init__(self):
        super().__init__(LiveController(Recording()), self._still)

    def _still(self, stamp):
        fallen = any(one.holds("fall", self.time) for one in self.disturbances)
        return Measurement(stamp, STANCE.copy(), np.zeros(8), TILTED if fallen else LEVEL, np.zeros(3))

    def follows(self):
        return self.live_controller.mode is Mode.WALKING and self.live_controller.moving(self.time)


def follows_after(*disturbances):
    """Time from the last disturbance until it follows the command for good, s; its mode, if it does not."""
    link = StandingLink()
    last = max(one.end for one in disturbances)
    link.disturbances = [*disturbances, *(one for one in BACKGROUND if one.start <= last)]
    lag = sum(one.seconds for one in disturbances if one.kind == "lag")
    # Every event is seen later by the lag.
    last = max(one.end + lag - (one.seconds if one.kind == "lag" else 0.0) for one in link.disturbances)
    since = None
    while link.time < last + WALKS_WITHIN + 0.3:
        link.step()
        if not link.follows():
            since = None
        elif since is None:
            since = link.time
    return link.live_controller.mode.value if since is None else max(0.0, since - last)


def test_background_goes_through_all_modes():
    link = StandingLink()
    link.disturbances = list(BACKGROUND)
    seen = {}
    while link.time < 15.0:
        link.step()
        seen.setdefault(link.live_controller.mode, link.time)
    assert set(seen) == set(Mode)
    assert link.follows()


def random_delay(kind, rng):
    """A delay at any moment of the background, and so in any mode."""
    return Disturbance(str(kind), float(rng.uniform(0.0, 12.0)), float(rng.uniform(0.1, 2.0)))


@pytest.mark.parametrize("kind", KINDS)
def test_live_controller_delayed_at_any_moment_follows_the_command_within_3_s(kind):
    rng = np.random.default_rng(KINDS.index(kind))
    for delay in [random_delay(kind, rng) for _ in range(2)]:
        assert follows_after(delay) <= WALKS_WITHIN, delay


@pytest.mark.slow
def test_live_controller_delayed_in_many_ways_follows_the_command_within_3_s():
    """Ten delays of each kind, and twenty times up to four of any kind."""
    rng = np.random.default_rng(0)
    trials = [[random_delay(kind, rng)] for kind in KINDS for _ in range(10)]
    trials += [[random_delay(rng.choice(KINDS), rng) for _ in range(rng.integers(2, 5))] for _ in range(20)]
    for delays in trials:
        assert follows_after(*delays) <= WALKS_WITHIN, delays


# --- single cases


def test_stale_states_are_refused_until_the_robot_is_limp_and_then_accepted():
    """The stream continues 0.3 s late, which counts as silence at first; once the robot is limp, it is accepted."""
    bench = Bench().walk()
    begin, late, refused = bench.now, 0.3, []
    bench.now += late
    while bench.mode is not Mode.WALKING or not refused:
        bench.now += PERIOD
        assert bench.now - begin < 3.0
        try:
            bench.feed(EPOCH + round((bench.now - late) * 1e9))
        except QuadrupedError as error:
            refused.append(str(error))
        answer = bench.live_controller.silent(bench.now)
        if answer is not None:
            bench.answers.append(answer)
    assert len(refused) == pytest.approx(70, abs=2)
    assert all("late by more than 0.2 s" in reason for reason in refused)
    assert sum(answer.target is LIMP for answer in bench.answers) == 1
    assert "all states arrive 0.30 s later than before; this lag is now taken as normal" in bench.said


def test_stale_states_among_fresh_ones_are_never_accepted():
    """Every other state is 0.5 s late for a long time, without motion: the fresh ones remain the reference."""
    timestamps = TimestampFilter("/test")
    for i in range(1000):
        now = 10.0 + i * PERIOD
        late = i % 2
        refusal = timestamps.refusal(round((now - 0.5 * late) * 1e9) + i, now, moving=False)
        assert bool(refusal) == bool(late)


def test_ramp_from_joints_far_beyond_their_range_takes_a_bounded_time():
    bench = Bench()
    bench.positions = np.full(8, 500.0)
    bench.pass_time(0.5)
    assert bench.mode is Mode.RAMPING
    bench.pass_time(8.0)
    assert bench.mode is Mode.WALKING


def test_ramp_after_a_delay_continues_where_it_was():
    """States come again after 0.9 s in which the process was suspended: the ramp continues where it was."""
    bench = Bench()
    bench.pass_time(0.7)
    before = bench.answers[-1].target
    bench.now += 0.9
    bench.feed()
    after = bench.answers[-1].target
    assert bench.mode is Mode.RAMPING
    assert np.abs(after - before).max() <= 1.5 * Safety().ramp_speed * 0.05 + 1e-9


def test_process_suspended_for_longer_than_the_watchdog_starts_again():
    """No joint command was sent meanwhile: the robot's own watchdog has made it limp."""
    bench = Bench().walk()
    bench.now += 1.5
    answer = bench.feed()
    assert answer.target is LIMP
    bench.pass_time(0.5)
    assert bench.mode is Mode.RAMPING


def test_limp_robot_that_sinks_is_moved_after_a_while_and_one_that_is_put_up_is_not():
    """The joints of a limp robot move slowly for a long time; if it fell, they move because it is lifted."""
    for fell, mode in ((False, Mode.RAMPING), (True, Mode.LIMP)):
        bench = Bench().walk()
        if fell:
            bench.orientation = np.array([math.cos(0.6), math.sin(0.6), 0.0, 0.0])
            bench.pass_time(0.5)
            bench.orientation = LEVEL
        else:
            bench.pass_time(1.5, states=False)
        for _ in range(150):
            bench.positions = bench.positions + 0.003
            bench.pass_time(PERIOD)
        assert bench.mode is mode


# --- in physics


class SimulatedLink(Link):
    """A link to the simulated robot, commanded to walk at 0.5 m/s."""

    def __init__(self, seed):
        self.robot = SimulatedRobot(seed)
        measure = functools.partial(measured, self.robot)
        super().__init__(LiveController(find_controller("flat").make()), measure, self.robot.command, (0.5, 0.0))

    def step(self):
        for _ in range(round(PERIOD / TIMESTEP)):
            self.robot.step()
        super().step()

    def until(self, modes, deadline):
        """Run until the live controller is in one of the modes; returns the time, s."""
        while self.live_controller.mode not in modes:
            assert self.time < deadline, self.live_controller.mode
            self.step()
        return self.time


def assert_walks_again(delay):
    """Assert that it walks within 3 s, or begins within 3 s to go to the stance or get up, which takes up to 6.5 s."""
    link = SimulatedLink(seed=0)
    link.disturbances = [delay]
    # A jump of the clock is noticed after 1 s only.
    while link.time < delay.end + (1.1 if delay.kind.startswith("clock") else 0.0):
        link.step()
    while link.live_controller.mode not in (Mode.RAMPING, Mode.WALKING):
        # The robot may stagger for a while before it falls.
        assert link.time < max([delay.end, *link.limp_times]) + WALKS_WITHIN, link.live_controller.mode
        link.step()
    getting_up = link.live_controller.mode is Mode.RAMPING
    link.until((Mode.WALKING,), delay.end + WALKS_WITHIN + (GETS_UP if getting_up else 0.0))
    began = link.time
    speeds = []
    while link.time < began + 2.0:
        link.step()
        speeds.append(link.robot.state.linear_velocity_b[0, 0])
    assert link.live_controller.mode is Mode.WALKING
    assert np.mean(speeds[100:]) > 0.4


@pytest.mark.parametrize("kind", PHYSICAL)
def test_robot_walks_again_after_a_delay(kind):
    rng = np.random.default_rng(KINDS.index(kind))
    assert_walks_again(Disturbance(kind, 4.0 + rng.uniform(), rng.uniform(0.1, 2.0)))
