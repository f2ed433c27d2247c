"""States at any rate: the controller acts at its own rate with the newest one, and says which rates are too low."""

import contextlib

import numpy as np
import pytest
from live_bench import EPOCH, Bench, Loop
from test_live_invalid import drive
from waiting import wait_until

from quadruped_env import QuadrupedError
from quadruped_env.control.live_controller import Mode
from quadruped_env.live.controller_inputs import SlowInputs
from quadruped_env.live.messages.joint_messages import Period

pytest.importorskip("cyclonedds")
pytest.importorskip("rosbags")

MS = 1_000_000


@pytest.mark.parametrize("rate", [25, 50])
def test_walked_speed_is_the_commanded_one_whatever_the_rate_of_the_states(rate):
    loop = Loop("flat", rate=rate)
    loop.run(3.5)
    speeds, upright = loop.run(5.0, (0.3, 0.0))
    assert np.mean(speeds[400:]) == pytest.approx(0.3, abs=0.02)
    assert upright.min() > 0.95
    assert loop.live_controller.mode is Mode.WALKING


def fed(bench, seconds, rate, jitter=0.0, clock=True):
    """Feed states at a rate in Hz, with jitter of timestamps and arrivals in s, in a loop of 1 ms.

    Without `clock`, time advances with the states alone, as in simulated time without /clock. Returns the times of the
    control ticks, s.
    """
    start, ticks, rng = bench.now, [], np.random.default_rng(0)
    sent = start + np.arange(1, round(seconds * rate) + 1) / rate
    taken = sent + rng.uniform(-jitter, jitter, len(sent))
    arrivals = taken + rng.uniform(0.0, jitter, len(sent))
    arrived = 0
    for step in range(1, round(1000 * seconds) + 1):
        now = start + step / 1000.0
        state = arrived < len(sent) and arrivals[arrived] <= now + 1e-9
        if not clock and not state:
            continue
        bench.now = now
        bench.live_controller.command((0.3, 0.0), now)
        before = len(bench.controller.commands)
        if state:
            # Timestamps that jitter by more than their period are not in order.
            with contextlib.suppress(QuadrupedError):
                bench.feed(EPOCH + round(taken[arrived] * 1e9))
            arrived += 1
        if answer := bench.live_controller.silent(now):
            bench.answers.append(answer)
        ticks += [now - start] * (len(bench.controller.commands) - before)
    return np.array(ticks)


@pytest.mark.parametrize(("jitter", "clock"), [(0.0, True), (0.004, True), (0.0, False)])
@pytest.mark.parametrize("rate", [20, 30, 50, 60, 200])
def test_control_ticks_have_their_own_rate(rate, jitter, clock):
    """Each tick advances clock and history once."""
    bench = Bench().walk()
    steps = bench.live_controller._control.steps[0]
    ticks = fed(bench, 5.0, rate, jitter, clock)
    assert bench.mode is Mode.WALKING
    assert len(ticks) == pytest.approx(250, abs=3)
    assert bench.live_controller._control.steps[0] - steps == len(ticks)
    assert bench.live_controller._control.time[0] == pytest.approx((len(ticks) + steps - 1) * 0.02)
    if clock:
        # Within the time for which a tick waits for its state, and that by which a state may precede it.
        grid = ticks - 0.02 * np.arange(len(ticks))
        assert np.ptp(grid) < 0.0175
        assert not jitter or np.ptp(grid) > 0.0
        if not jitter and (rate % 50 == 0 or rate < 30):
            np.testing.assert_allclose(np.diff(ticks[15:]), 0.02, atol=0.0011)
    else:
        assert np.unique(ticks, return_counts=True)[1].max() <= 3


def test_ticks_wait_for_states_whose_timestamps_and_arrivals_jitter():
    """At the control rate, every state is answered once."""
    bench = Bench().walk()
    fed(bench, 4.0, 50, 0.004)
    stamps = [answer.stamp for answer in bench.answers[-190:]]
    assert len(set(stamps)) == len(stamps)


def test_ticks_that_a_suspended_process_missed_are_not_made_up_for():
    bench = Bench().walk()
    before = len(bench.controller.commands)
    bench.now += 0.15
    bench.feed()
    assert len(bench.controller.commands) == before + 1
    bench.pass_time(1.0, command=(0.3, 0.0))
    assert len(bench.controller.commands) == pytest.approx(before + 51, abs=1)


def test_remaining_time_is_that_to_the_next_tick():
    bench = Bench()
    assert bench.live_controller.remaining(bench.now) == np.inf
    bench.walk()
    fed(bench, 1.0, 25)
    answered = None
    while answered is None:
        remaining = bench.live_controller.remaining(bench.now)
        assert 0.0 < remaining <= 0.03
        assert bench.live_controller.silent(bench.now + 0.99 * remaining) is None
        answered = bench.live_controller.silent(bench.now + remaining + 1e-6)


def test_robot_that_is_held_gets_commands_until_it_moves_again():
    """States at 6 Hz: twenty of them take longer than the watchdog of the motors."""
    bench = Bench().walk()
    bench.pass_time(0.3, states=False)
    assert bench.mode is Mode.HOLDING
    since, longest = bench.now, 0.0
    for i in range(200):
        bench.now += 0.01
        answer = bench.feed() if i % 16 == 0 else None
        if answer or bench.live_controller.silent(bench.now):
            longest, since = max(longest, bench.now - since), bench.now
    assert bench.mode is Mode.HOLDING
    assert longest < 0.05


# --- the rates in log and diagnostics


def test_rate_is_that_of_different_timestamps_without_silences():
    stream = Period()
    for i in range(10):
        stream.add(i * 40 * MS)
        assert stream.rate is None
    stream.add(400 * MS)
    assert stream.rate == pytest.approx(25.0)
    stream.add(400 * MS)
    stream.add(2000 * MS)
    assert stream.rate == pytest.approx(25.0)
    # Every third one is lost.
    for i in range(300):
        if i % 3:
            stream.add(2000 * MS + i * 10 * MS)
    assert stream.rate == pytest.approx(66.7, abs=1.0)


def test_slow_inputs_are_named_once_until_that_changes():
    said = []
    slow = SlowInputs(50.0, said.append)
    slow._pace.tick = lambda: True
    slow.update({})
    assert (said, slow.warning) == ([], "")
    slow.update({"/joint_states": 100.2, "/imu/data": 49.0})
    assert said == ["/joint_states at 100 Hz, /imu/data at 49 Hz; control rate 50 Hz"]
    for rate in (25.0, 26.0, 46.9, 25.0):
        slow.update({"/joint_states": rate, "/imu/data": 49.0})
    assert slow.warning == "/joint_states at 25 Hz, below the control rate of 50 Hz"
    assert said[1:] == [
        f"{slow.warning}: control steps without a new state use the last one, and the policy may walk worse"
    ]
    slow.update({"/joint_states": 48.0, "/imu/data": 49.0})
    assert slow.warning == ""
    assert said[2:] == ["/joint_states at 48 Hz, /imu/data at 49 Hz; control rate 50 Hz"]


@pytest.mark.parametrize(("every", "level"), [(1, 0), (4, 1)])
def test_rates_stand_in_log_and_diagnostics(nodes, run_node, every, level):
    send, _, statuses, log = drive(nodes, run_node, every=every)
    found = []

    def reported():
        send()
        for one in statuses.take():
            (status,) = statuses.decode(one).status
            values = {entry.key: entry.value for entry in status.values}
            # Those before it walks are WARN for another reason.
            if status.message.startswith("following") and "/joint_states, Hz by timestamps" in values:
                found.append((status.level, status.message, values))
        return found

    wait_until(reported, lambda: log.said, interval=0.004)
    rate = 100 // every
    shown, message, values = found[0]
    assert shown == level
    assert float(values["/joint_states, Hz by timestamps"]) == pytest.approx(rate, rel=0.2)
    assert float(values["/imu/data, Hz by timestamps"]) == pytest.approx(rate, rel=0.2)
    assert values["control rate, Hz"] == "50"
    if level:
        assert "/joint_states at 2" in message
        assert "below the control rate of 50 Hz: control steps without a new state" in log.said
    else:
        assert message == "following the command"
        assert "; control rate 50 Hz" in log.said
