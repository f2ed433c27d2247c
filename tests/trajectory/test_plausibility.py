"""Lies of robots' logs, each planted in a recording that has a closed form, and real recordings, which have none."""

import re
from dataclasses import replace

import numpy as np
import pytest
from paths import DYNA1, ROOT

from quadruped_env import JOINT_NAMES, JointTrajectory
from quadruped_env.cli.main import main
from quadruped_env.trajectory import ColumnMap, JointMap, JointRule
from quadruped_env.trajectory.plausibility import findings
from quadruped_env.trajectory.rows import Rows

RECORDINGS = DYNA1.parent / "recordings"
MAP = ROOT / "assets" / "maps" / "dyna1.toml"


def recording(rate=100.0, seconds=10.0, noise=0.0):
    """Eight joints that swing at frequencies of their own, up to 8 rad/s."""
    t = np.arange(round(seconds * rate)) / rate
    frequency = 2.0 * np.pi * (0.7 + 0.31 * np.arange(8))
    phase = frequency * t[:, None] + np.arange(8)
    rng = np.random.default_rng(0)
    values = {
        "position": 0.4 * np.sin(phase) + 0.05 * np.sin(3.3 * phase),
        "velocity": frequency * (0.4 * np.cos(phase) + 0.165 * np.cos(3.3 * phase)),
        "effort": 2.0 * np.sin(phase + 0.5),
    }
    for kind, size in zip(values, (noise, 20.0 * noise, 50.0 * noise), strict=True):
        values[kind] += rng.normal(0.0, size, phase.shape)
    return Rows(np.arange(len(t)), np.rint(t * 1e9).astype(np.int64), JOINT_NAMES, values)


def planted(lie, **options):
    """The recording after statements have changed timestamps s (n,), positions q, velocities v, efforts e (n, 8)."""
    rows = recording(**options)
    exec(lie, {"np": np, "s": rows.stamps, **dict(zip("qve", rows.values.values(), strict=True))})  # noqa: S102
    return rows


LIES = {
    "wrap": ("q[:, 0] = (q[:, 0] + 3.0 + np.pi) % (2 * np.pi) - np.pi", "wrap",
             r"by 6\.283 rad between two lines in LF_hip_joint, first at .* s \(line \d+\), \d+ times; .*--unwrap"),
    "spikes": ("q[300, 0] -= 6.02; q[500, 3] += 0.4", "jump",
               r"by 6 rad in 0\.01 s in LF_hip_joint, RF_knee_joint, first at 3\.000 s .*, 2 times; .*--repair des"),
    "jump": ("q[400:, 2] += 0.8", "jump",
             r"by 0\.\d+ rad in 0\.01 s, \d+ rad/s, in RF_hip_joint, at 4\.000 s \(line 400\); cut there"),
    "two publishers": ("q[1::2] -= 1.0", "jump",
                       r"in 100 % of the steps of LF_hip_joint, .* by up to 1\.\d+ rad in 0\.01 s, 1\d\d rad/s, first "
                       r"at 0\.010 s \(line 1\), 79\d\d times; two publishers .*--unit deg"),
    "publisher of every third": ("q[::3] -= 0.5", "jump", r"in 6\d % of the steps of LF_hip_joint, .*joint tar"),
    "swapped in half of the rows": ("q[::2, [2, 5]] = q[::2, [5, 2]]", "jump",
                                    r"in \d\d % of the steps of RF_hip_joint, LH_knee_joint, as no joint"),
    "overflow": ("q[:, 3] = np.mod(40 * q[:, 3], 4.0) - 2.0", "jump", r"in \d+ % of the steps of RF_knee_joint,"),
    "noise": ("q[:, 6] = np.random.default_rng(0).normal(0, 1, len(q))", "jump", r"\d % of the steps of RH_hip"),
    "degrees": ("q *= 20; v *= 20", "jump", r"70 % of the steps of .*--unit deg"),
    "freeze": ("q[300:320] = q[300]", "frozen",
               r"for up to 0\.19 s in LF_hip_joint, .*, first at 3\.000 s \(line 300\), 7 times; cut"),
    "freeze of one": ("q[300:340, 5] = q[300, 5]", "frozen", r"for up to 0\.39 s in LH_knee_joint, at 3\.000 s"),
    "freeze to the end": ("q[700:] = q[700]", "frozen",
                          r"up to 2\.99 s in LF_hip_joint, .* and 5 more, first at 7\.000 s \(line 700\), 8 times"),
    "dead": ("q[:, 4] = 0.25", "frozen", r"for up to 9\.99 s in LH_hip_joint, at 0\.000 s .*, or leave the joint out"),
    "milliseconds": ("s //= 1_000_000", "timestamps",
                     r"between lines is 1e-08 s, .* another unit; name it \(stamp_unit .*--stamps"),
    "clock": ("s[500:] += 3600 * 10**9", "timestamps", r"jump by 3600 s at 4\.990 s \(line 499\) .*--stamps 0\.01"),
    "bursts": ("i = np.arange(len(s)); s[:] = i // 10 * 100_000_000 + i % 10 * 100_000", "timestamps",
               r"in bursts: 900 of 1000 lines follow"),
    "degrees/s": ("v *= 180 / np.pi", "velocity", r"are 57\.\d.* times .*degrees/s.*velocity_unit"),
    "flipped": ("q[:, 6] *= -1", "velocity", r"of RH_hip_joint have the opposite sign"),
    "swapped": ("v[:, [1, 2]] = v[:, [2, 1]]", "velocity",
                r"of LF_knee_joint, RF_hip_joint fit the positions of other joints .* \(RF_hip_joint for LF_knee"),
    "no velocity": ("v[:] = 0.0", "velocity", r"LF_hip_joint, LF_knee_joint, RF_hip_joint and 5 more are 0 while"),
    "velocity spikes": ("v[[200, 600], 7] = 186.0, -150.0", "velocity",
                        r"186 rad/s in RH_knee_joint, first at 2\.000 s \(line 200\), 2 times; .*--ignore velocity"),
    "no effort": ("e[:] = 0.0", "effort", r"are 0 in every line while the joints move.*--ignore effort"),
    "constant effort": ("e[:] = 1.5", "effort", r"are 1\.5 in every line while the joints move"),
    "milliamperes": ("e *= 1000.0", "effort", r"reach 2000, which are no N m of a leg; .*effort_scale"),
    "copied": ("e[:] = v", "effort", r"effort and velocity are the same numbers .*--ignore effort"),
    "copied joint": ("q[:, 1] = q[:, 0]; v[:, 1] = v[:, 0]", "jump", r"LF_hip_joint and LF_knee_joint have the same"),
}  # fmt: skip


@pytest.mark.parametrize("name", LIES)
def test_planted_lie_is_found_with_its_place_and_repair(name):
    lie, kind, text = LIES[name]
    found = findings(planted(lie), "line")
    said = "\n".join(finding.text for finding in found if finding.kind == kind)
    assert re.search(text, said), found
    # Positions that cannot be say nothing about velocities.
    assert "as no joint can" not in said or "velocity" not in {finding.kind for finding in found}


@pytest.mark.parametrize("rate", [30.0, 50.0, 100.0, 200.0, 500.0, 1000.0])
def test_findings_of_honest_recordings_are_none(rate):
    rng = np.random.default_rng(1)
    rows = recording(rate)
    position, times = rows.values["position"], rows.stamps / 1e9
    ticks = np.rint(position / 0.0015) * 0.0015
    filtered = rows.values["velocity"].copy()
    for i in range(1, len(rows)):
        filtered[i] = filtered[i - 1] + min(1.0, 60.0 / rate) * (filtered[i] - filtered[i - 1])
    jitter = np.maximum.accumulate(rows.stamps + np.rint(rng.normal(0.0, 2e8 / rate, len(rows))).astype(np.int64))
    keep = rng.random(len(rows)) > 0.2
    keep[len(rows) // 2 : len(rows) // 2 + round(rate)] = False

    def changed(**values):
        return replace(rows, values=rows.values | values)

    honest = {
        "exact": rows,
        "noise": recording(rate, noise=0.003),
        "encoder": changed(position=ticks, velocity=np.gradient(ticks, times, axis=0)),
        "filtered at 10 Hz": changed(velocity=filtered),
        "jitter": replace(rows, stamps=jitter + np.arange(len(jitter))),
        "gaps": rows.take(keep),
        "positions alone": replace(rows, values={"position": position}),
        "every third": rows.take(np.s_[:: 3 if rate > 50.0 else 1]),
        "whole degrees": changed(position=np.radians(np.rint(np.degrees(position)))),
        "standing": changed(position=np.round(0.001 * position, 4), velocity=0.02 * rows.values["effort"]),
        "one joint at rest": changed(
            **{kind: np.where(np.arange(8) == 4, 0.0, rows.values[kind]) for kind in rows.values}
        ),
    }
    assert {name: [one.text for one in findings(found)] for name, found in honest.items()} == {
        name: [] for name in honest
    }


def test_load_of_efforts_that_are_all_nan_has_none_and_says_so(tmp_path, capsys):
    rows = planted("e[:] = np.nan", seconds=0.1)
    JointTrajectory(rows.stamps, rows.names, *rows.values.values()).save(tmp_path / "a.csv")
    loaded = JointTrajectory.load(tmp_path / "a.csv")
    assert (loaded.efforts, loaded.source.notes) == (None, ("efforts are NaN in every line: they were not recorded",))
    assert main(["convert", str(tmp_path / "a.csv"), str(tmp_path / "b.csv")]) == 0
    assert re.search(r"Hz: positions, velocities\n(.*\n)*efforts are NaN in every line", capsys.readouterr().out)
    # One that is known in a later piece of the file is enough.
    rows = planted("e[:] = np.nan; e[-1, 2] = 0.5", rate=1000.0, seconds=4.2)
    JointTrajectory(rows.stamps, rows.names, *rows.values.values()).save(tmp_path / "c.csv")
    assert JointTrajectory.load(tmp_path / "c.csv").efforts[-1, 2] == 0.5


def test_wraps_of_a_geared_encoder_in_many_rows_are_wraps():
    rows = planted("v[:, 0] = 12.0; q[:, 0] = 12.0 * s / 1e9 % (np.pi / 2)")
    found = findings(rows, "line", (2 * np.pi, np.pi / 2))
    assert [finding.kind for finding in found] == ["wrap"]
    assert re.search(r"wrap by 1\.571 rad .* in LF_hip_joint, .* 76 times", found[0].text)


class TestRepairs:
    @staticmethod
    def load(tmp_path, rows, **options):
        JointTrajectory(rows.stamps, rows.names, *rows.values.values()).save(tmp_path / "a.csv", overwrite=True)
        return JointTrajectory.load(tmp_path / "a.csv", **options)

    @staticmethod
    def lie(name):
        return planted(LIES[name][0])

    def test_load_unwrap_undoes_wraps_of_a_turn_or_a_given_angle(self, tmp_path):
        truth = recording().values["position"]
        turned = self.load(tmp_path, self.lie("wrap"), unwrap=2 * np.pi)
        np.testing.assert_allclose(
            turned.positions[:, 0] - turned.positions[0, 0], truth[:, 0] - truth[0, 0], atol=1e-12
        )
        np.testing.assert_array_equal(turned.positions[:, 1:], truth[:, 1:])
        assert turned.source.notes[0].endswith("steps of about 6.283 rad, undone")

        def named(notes):
            return [note for note in notes if "--unwrap" in note]

        rows = planted("q[:, 0] = (q[:, 0] + 1.4) % (np.pi / 2)")
        assert "(--unwrap 1.5" in named(self.load(tmp_path, rows).source.notes)[0]
        undone = self.load(tmp_path, rows, unwrap=np.pi / 2)
        np.testing.assert_allclose(
            undone.positions[:, 0] - undone.positions[0, 0], truth[:, 0] - truth[0, 0], atol=1e-12
        )
        assert not named(undone.source.notes)

    @pytest.mark.parametrize(
        "rule",
        [
            JointRule("LF_hip_joint", scale=0.25),
            JointRule("LF_hip_joint", gear=4.0, sign=-1.0),
            JointRule(sources={"LF_hip_joint": -0.25, "RF_hip_joint": 0.5}),
        ],
    )
    def test_load_of_a_geared_encoder_names_the_angle_of_its_turn_at_the_joint(self, tmp_path, rule):
        geared = JointMap({"knee": rule})
        notes = self.load(tmp_path, self.lie("wrap"), joint_map=geared).source.notes
        assert "by 1.571 rad between two lines in knee" in notes[0]
        assert "(--unwrap 1.5708)" in notes[0]

    def test_load_despike_leaves_the_rows_of_spikes_out(self, tmp_path):
        loaded = self.load(tmp_path, self.lie("spikes"), repair=["despike"])
        kept = np.delete(np.arange(1000), [300, 500])
        np.testing.assert_array_equal(loaded.positions, recording().values["position"][kept])
        assert loaded.source.notes == ("left out 2 of 1000: a joint is elsewhere for a few rows",)

    @pytest.mark.parametrize("name", ["milliseconds", "clock", "bursts"])
    def test_load_stamps_of_a_period_replace_timestamps(self, tmp_path, name):
        loaded = self.load(tmp_path, self.lie(name), stamps=0.01)
        assert (loaded.stamps.tolist(), loaded.source.notes) == (recording().stamps.tolist(), ())

    @pytest.mark.parametrize("name", ["degrees/s", "swapped", "no velocity", "velocity spikes"])
    def test_load_ignore_leaves_nothing_to_report(self, tmp_path, name):
        assert self.load(tmp_path, self.lie(name), ignore=["velocity"]).source.notes == ()


REAL = [
    ("../dyna1/measured.csv", {"columns": MAP, "joint_map": MAP}, None),
    ("../dyna1/control.csv", {"columns": MAP, "joint_map": MAP}, None),
    ("minitaur/minitaur_spikes_500rows.csv", {}, r"by 6\.02 rad in 0\.01 s in q0, at 0\.520 s \(line 54\)"),
    ("minitaur/minitaur_walk_2000rows.csv", {}, None),
    ("laikago/data1.txt", {"columns": ColumnMap(2, {f"j{i}": i + 3 for i in range(12)}, stamp_unit="ms")},
     r"line 2499: the last line does not end, so its last value, '-1\.246940'"),
    ("opencat/bittle_trF_degrees_no_time.csv", {}, None),
    ("opencat/bittle_wkF_degrees_no_time.csv", {}, None),
]  # fmt: skip


@pytest.mark.parametrize(("name", "options", "said"), REAL, ids=[name for name, _, _ in REAL])
def test_load_of_a_real_recording_says_what_is_wrong_with_it_and_nothing_else(name, options, said):
    path = RECORDINGS / name
    if not path.exists():
        pytest.skip(f"{path.name} is not here: expected shared/data in the checkout or next to it")
    if "minitaur" in name:
        options = {"columns": ColumnMap("t", [f"q{i}" for i in range(8)], stamp_unit="ms")}
    elif "opencat" in name:
        options = {"columns": ColumnMap(None, [f"a{i}" for i in range(8, 16)], period=0.02), "unit": "deg"}
    notes = JointTrajectory.load(path, **options).source.notes
    assert len(notes) == (said is not None)
    if said is not None:
        assert re.search(said, notes[0]), notes
