"""Whatever is late, lost or held up, and whenever: the robot soon walks again."""

import math
import signal
import time
from collections import deque

import numpy as np
import pytest
from live_bench import EPOCH, LEVEL, Bench
from live_delays import COMMAND_PERIOD, KINDS, PERIOD, Disturbance, Link
from waiting import wait_until

from quadruped_env import QuadrupedError
from quadruped_env.control.joint_command import LIMP
from quadruped_env.control.live_controller import LiveController, Measurement, Mode, Safety
from quadruped_env.control.timestamp_filter import TimestampFilter
from quadruped_env.live import Node
from quadruped_env.live.simulated import TIMESTEP, SimulatedRobot
from quadruped_env.live.topics import CMD_VEL, ODOMETRY
from quadruped_env.policies import find_controller
from quadruped_env.robot import STANCE
from quadruped_env.ros import Qos, cdr

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

WALKS_WITHIN = 3.0
"""s after the end of a disturbance. It is time in the simulation, and so no matter of the machine's speed."""
GETS_UP = 6.5
"""s, of which 5 are the longest way to the stance"""
PHYSICAL = tuple(kind for kind in KINDS if kind != "lag")
"""Delays that a robot can stand: no policy walks on states that are old for good, if that is what a lag is"""
TILTED = np.array([np.cos(0.6), np.sin(0.6), 0.0, 0.0])
BACKGROUND = (Disturbance("loss", 4.0, 0.6), Disturbance("loss", 6.5, 1.6), Disturbance("fall", 10.5, 0.7))
"""What brings the pilot through all its modes: it holds at 4.2 s, ramps, waits limp from 7.5 to 8.3 s, and lies"""


class Asks:
    """A controller that asks for the stance."""

    action_mode = "position"
    name = "stance"

    def act(self, observation, control):
        return STANCE[None].copy()


class Still(Link):
    """A robot that stays in its stance, and is laid on its side and put up again once."""

    def __init__(self):
        super().__init__(LiveController(Asks()), self._still)

    def _still(self, stamp):
        fallen = any(one.holds("fall", self.time) for one in self.disturbances)
        return Measurement(stamp, STANCE.copy(), np.zeros(8), TILTED if fallen else LEVEL, np.zeros(3))

    def follows(self):
        return self.pilot.mode is Mode.WALKING and self.pilot.moving(self.time)


def follows_after(*disturbances):
    """s from the last disturbance until it follows the command for good; the mode that it is in, if it does not."""
    link = Still()
    last = max(one.end for one in disturbances)
    link.disturbances = [*disturbances, *(one for one in BACKGROUND if one.start <= last)]
    lag = sum(one.seconds for one in disturbances if one.kind == "lag")
    # What happens is seen that much later.
    last = max(one.end + lag - (one.seconds if one.kind == "lag" else 0.0) for one in link.disturbances)
    since = None
    while link.time < last + WALKS_WITHIN + 0.3:
        link.turn()
        if not link.follows():
            since = None
        elif since is None:
            since = link.time
    return link.pilot.mode.value if since is None else max(0.0, since - last)


def test_background_goes_through_all_modes():
    link = Still()
    link.disturbances = list(BACKGROUND)
    seen = {}
    while link.time < 15.0:
        link.turn()
        seen.setdefault(link.pilot.mode, link.time)
    assert set(seen) == set(Mode)
    assert link.follows()


def random_delay(kind, rng):
    """At any moment of the background, in any mode."""
    return Disturbance(str(kind), float(rng.uniform(0.0, 12.0)), float(rng.uniform(0.1, 2.0)))


@pytest.mark.parametrize("kind", KINDS)
def test_pilot_delayed_at_any_moment_follows_the_command_within_3_s(kind):
    rng = np.random.default_rng(KINDS.index(kind))
    for delay in [random_delay(kind, rng) for _ in range(5)]:
        assert follows_after(delay) <= WALKS_WITHIN, delay


@pytest.mark.slow
def test_pilot_delayed_in_many_ways_follows_the_command_within_3_s():
    """Ten delays of each kind, and twenty times up to four of any kind."""
    rng = np.random.default_rng(0)
    trials = [[random_delay(kind, rng)] for kind in KINDS for _ in range(10)]
    trials += [[random_delay(rng.choice(KINDS), rng) for _ in range(rng.integers(2, 5))] for _ in range(20)]
    for delays in trials:
        assert follows_after(*delays) <= WALKS_WITHIN, delays


# --- by hand


def test_stale_states_are_refused_until_the_robot_is_limp_and_then_become_the_measure():
    """The stream goes on, 0.3 s late: as good as silence at first. Limp, the robot may be moved on what there is."""
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
        answer = bench.pilot.silent(bench.now)
        if answer is not None:
            bench.answers.append(answer)
    assert len(refused) == pytest.approx(70, abs=2)
    assert all("late by more than 0.2 s" in reason for reason in refused)
    assert sum(answer.target is LIMP for answer in bench.answers) == 1
    assert "all states arrive 0.30 s later than before; this lag is now taken as normal" in bench.said


def test_stale_states_among_fresh_ones_never_become_the_measure():
    """Every other state is 0.5 s late, for long, and while nothing moves: the fresh ones stay the measure."""
    gate = TimestampFilter("/test")
    for i in range(1000):
        now = 10.0 + i * PERIOD
        late = i % 2
        refusal = gate.refusal(round((now - 0.5 * late) * 1e9) + i, now, moving=False)
        assert bool(refusal) == bool(late)


def test_ramp_from_joints_far_beyond_their_range_has_its_bounded_time():
    bench = Bench()
    bench.positions = np.full(8, 500.0)
    bench.pass_time(0.5)
    assert bench.mode is Mode.RAMPING
    bench.pass_time(8.0)
    assert bench.mode is Mode.WALKING


def test_ramp_is_not_hurried_by_a_delay():
    """States come again after 0.9 s in which the process was held up: the ramp goes on where it was."""
    bench = Bench()
    bench.pass_time(0.7)
    before = bench.answers[-1].target
    bench.now += 0.9
    bench.feed()
    after = bench.answers[-1].target
    assert bench.mode is Mode.RAMPING
    assert np.abs(after - before).max() <= 1.5 * Safety().ramp_speed * 0.05 + 1e-9


def test_process_held_up_for_longer_than_the_watchdog_begins_anew():
    """Nobody asked for a command meanwhile: the robot's own watchdog has let its motors go."""
    bench = Bench().walk()
    bench.now += 1.5
    answer = bench.feed()
    assert answer.target is LIMP
    bench.pass_time(0.5)
    assert bench.mode is Mode.RAMPING


def test_sinking_robot_is_moved_after_a_while_and_one_that_is_put_up_is_not():
    """Let go, its joints move slowly for long; a robot that fell is in somebody's hands."""
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


class Walking(Link):
    """The simulated robot, at 0.5 m/s."""

    def __init__(self, seed):
        self.robot = SimulatedRobot(seed)
        super().__init__(LiveController(find_controller("flat").make()), self._measured, self.robot.command, (0.5, 0.0))

    def _measured(self, stamp):
        state = self.robot.state
        return Measurement(
            stamp,
            state.joint_position[0].copy(),
            state.joint_velocity[0].copy(),
            state.orientation[0].copy(),
            state.angular_velocity_b[0].copy(),
        )

    def turn(self):
        for _ in range(round(PERIOD / TIMESTEP)):
            self.robot.step()
        super().turn()

    def until(self, modes, deadline):
        """Run until it is in one of the modes; s."""
        while self.pilot.mode not in modes:
            assert self.time < deadline, self.pilot.mode
            self.turn()
        return self.time


def assert_walks_again(delay):
    """Within 3 s; where the robot was let go, it begins to get up within 3 s, which takes it up to 6.5 s."""
    link = Walking(seed=0)
    link.disturbances = [delay]
    # A jump of the clock is noticed after 1 s only.
    while link.time < delay.end + (1.1 if delay.kind.startswith("clock") else 0.0):
        link.turn()
    let_go = bool(link.let_go)
    link.until((Mode.RAMPING, Mode.WALKING), delay.end + WALKS_WITHIN)
    link.until((Mode.WALKING,), delay.end + WALKS_WITHIN + (GETS_UP if let_go else 0.0))
    began = link.time
    speeds = []
    while link.time < began + 2.0:
        link.turn()
        speeds.append(link.robot.state.linear_velocity_b[0, 0])
    assert link.pilot.mode is Mode.WALKING
    assert np.mean(speeds[100:]) > 0.4


@pytest.mark.parametrize("kind", PHYSICAL)
def test_robot_walks_again_after_a_delay(kind):
    rng = np.random.default_rng(KINDS.index(kind))
    assert_walks_again(Disturbance(kind, 4.0 + rng.uniform(), rng.uniform(0.1, 2.0)))


@pytest.mark.slow
@pytest.mark.parametrize("kind", PHYSICAL)
def test_robot_walks_again_after_many_delays(kind):
    rng = np.random.default_rng(100 + KINDS.index(kind))
    for seconds in np.linspace(0.1, 2.0, 5):
        assert_walks_again(Disturbance(kind, 4.0 + rng.uniform(), float(seconds)))


@pytest.mark.slow
def test_processes_held_up_and_started_again_walk_again(start, domain_id):
    """The controller is stopped and goes on, and is ended and started, while /cmd_vel comes all the time."""
    node = Node("watcher")
    velocities, odometry = node.publish(CMD_VEL), node.subscribe(ODOMETRY, Qos(1000))
    twist = cdr.message(CMD_VEL.type_name, linear={"x": 0.5})
    speeds = deque(maxlen=100)

    def walks():
        velocities.send(twist)
        speeds.extend(one.twist.twist.linear.x for _, one in odometry.messages(pytest.fail))
        return len(speeds) == speeds.maxlen and abs(np.mean(speeds) - 0.5) < 0.15

    def walks_again(what):
        speeds.clear()
        wait_until(walks, what, interval=COMMAND_PERIOD)

    try:
        start("sim")
        for seconds in (0.3, 0.9, 1.6):
            controller = start("controller")
            walks_again(f"walking, before {seconds} s")
            controller.process.send_signal(signal.SIGSTOP)
            # Not a wait for anything: this is the delay.
            time.sleep(seconds)
            controller.process.send_signal(signal.SIGCONT)
            walks_again(f"walking after {seconds} s")
            assert controller.interrupt() == 0
    finally:
        node.close()
