"""The robot that is written against the file that was read, by MuJoCo's and yourdfpy's reading of the latter."""

import re

import mujoco
import numpy as np
import pytest
import yourdfpy
from public_robots import answers, place
from urdf_robots import CORNERS, MASS, SHANK, THIGH, imported, robot

from quadruped_env.control.task_file import load_robot
from quadruped_env.importer import import_robot

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
OPEN = '<mujoco><compiler fusestatic="false" inertiafromgeom="false"/></mujoco></robot>'


def written(read, folder):
    """The robot of the files that the importer writes."""
    (folder / "robot.xml").write_text(read.mjcf, encoding="utf-8")
    (folder / "robot.py").write_text(read.task_file("robot.xml"), encoding="utf-8")
    return load_robot(folder / "robot.py")


def positions_of(model, read, joints, frame):
    """Feet of the file's own model (4, 3), in the axes of the robot that was written, about the first foot."""
    data = mujoco.MjData(model)
    for name, value in joints.items():
        data.qpos[model.joint(name).qposadr[0]] = value
    mujoco.mj_kinematics(model, data)
    base = model.body(read.bodies[0].name).id
    feet = []
    for leg in read.anatomy.legs:
        body = model.joint(leg.names[-1]).bodyid[0]
        anchor = data.xanchor[model.joint(leg.names[-1]).id]
        feet.append(anchor + data.xmat[body].reshape(3, 3) @ leg.foot_in_link)
    return (np.array(feet) - feet[0]) @ (data.xmat[base].reshape(3, 3) @ frame)


def feet_of(made, read, joints):
    order = [f"{leg.corner}_foot" for leg in read.anatomy.legs]
    found = made.skeleton.foot_centres([joints[name] for name in made.joint_names])
    feet = found[[made.foot_sites.index(name) for name in order]]
    return feet - feet[0]


def random_joints(made, rng):
    values = rng.uniform(made.joint_position_low, made.joint_position_high)
    return dict(zip(made.joint_names, values, strict=True))


def check_feet(made, read, model):
    rng = np.random.default_rng(0)
    for _ in range(10):
        joints = random_joints(made, rng)
        expected = positions_of(model, read, joints, read.anatomy.frame)
        np.testing.assert_allclose(feet_of(made, read, joints), expected, rtol=0.0, atol=1e-6)


PLATE = (
    '<link name="plate"><inertial><origin xyz="0.01 0.02 0.03" rpy="0.3 0.5 0.7"/><mass value="0.3"/>'
    '<inertia ixx="0.001" iyy="0.002" izz="0.0025" ixy="0.0001" ixz="0.0002" iyz="-0.0003"/></inertial></link>'
    '<joint name="mount" type="fixed"><parent link="LF_shank"/><child link="plate"/>'
    '<origin xyz="0.04 0.05 -0.06" rpy="1.1 -0.4 0.8"/></joint>'
)


def twisted(joints):
    """A robot whose knees are bent at 0, and that has a plate on each shank; its mass is 1.2 kg more."""
    plates = [PLATE.replace("LF", c).replace("plate", f"{c}_plate").replace("mount", f"{c}_mount") for c in CORNERS]
    turned = [plate.replace("1.1 -0.4", f"{i} {0.3 * i}") for i, plate in enumerate(plates)]
    return robot(joints, extra="".join(turned)).replace(f'xyz="0 0 {-THIGH}"', f'xyz="0 0 {-THIGH}" rpy="0 0.4 0"')


def test_written_robot_has_the_feet_of_an_mjcf_whose_joints_are_off_their_bodies(tmp_path):
    text = imported(robot(3), tmp_path).mjcf.replace('axis="0 1 0"', 'axis="0 1 0" pos="0.01 0.02 0.03"')
    read = imported(text, tmp_path, "off.xml")
    check_feet(written(read, tmp_path), read, mujoco.MjModel.from_xml_string(text))


@pytest.mark.parametrize("joints", [2, 3])
def test_written_robot_has_the_feet_mass_and_inertia_of_the_read_one(tmp_path, joints):
    text = twisted(joints)
    read = imported(text, tmp_path)
    made = written(read, tmp_path)
    original = mujoco.MjSpec.from_string(text.replace("</robot>", OPEN))
    original.body("base").add_freejoint()
    model = original.compile()
    check_feet(made, read, model)
    assert made.total_mass == pytest.approx(MASS + 1.2 if joints == 3 else MASS, rel=1e-9)
    values, matrices = random_joints(made, np.random.default_rng(1)), []
    for each in (model, made.skeleton.model):
        data = mujoco.MjData(each)
        data.qpos[:7] = [0, 0, 0, 1, 0, 0, 0]
        for name, value in values.items():
            data.qpos[each.joint(name).qposadr[0]] = value
        each.dof_armature[:] = 0.0
        mujoco.mj_forward(each, data)
        matrix = np.zeros((each.nv, each.nv))
        mujoco.mj_fullM(each, data, matrix)
        order = [*range(6), *(each.joint(name).dofadr[0] for name in made.joint_names)]
        matrices.append(matrix[np.ix_(order, order)])
    np.testing.assert_allclose(matrices[1], matrices[0], rtol=1e-6, atol=1e-9)


def _original(path, text):
    """MuJoCo's own reading of a file, without shapes and with an inertia that it accepts."""
    if path.suffix == ".xml":
        return mujoco.MjModel.from_xml_path(str(path))
    bare = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    bare = re.sub(r"<(inertial|visual|collision|mujoco)\b.*?</\1>", "", bare, flags=re.DOTALL).replace("</link>", "")
    bare = re.sub(r"<link\b([^>]*?)/?>", rf"<link\1>{INERTIAL}</link>", bare)
    return mujoco.MjModel.from_xml_string(bare.replace("</robot>", OPEN))


@pytest.mark.parametrize(
    "answer", [a for a in answers() if a["answer"] == "robot"] or [None], ids=lambda a: a and a["file"]
)
def test_written_public_robot_has_the_feet_of_the_read_one(tmp_path, answer):
    if answer is None:
        pytest.skip("the answers are not here")
    path, folders = place(answer)
    read = import_robot(path, folders)
    made = written(read, tmp_path)
    check_feet(made, read, _original(path, path.read_text(encoding="utf-8")))
    assert made.total_mass == pytest.approx(read.mass, rel=1e-9)
    # It stands: every foot is on the ground in the stance, and nothing else is below it.
    feet = made.skeleton.foot_centres(made.stance)[:, 2]
    assert np.ptp(feet) < 0.01 * made.stance_height
    assert made.skeleton.lowest(made.stance, np.array([0.0, 0.0, 1.0])) == pytest.approx(
        feet.min() - made.foot_radius, abs=1e-3
    )


@pytest.mark.parametrize("joints", [2, 3])
def test_feet_are_where_yourdfpy_has_them(tmp_path, joints):
    text = robot(joints, axis="0 -1 0", knee='lower="0.2" upper="2.6"')
    read = imported(text, tmp_path)
    made = written(read, tmp_path)
    other = yourdfpy.URDF.load(str(tmp_path / "made.urdf"), load_meshes=False, load_collision_meshes=False)
    values = random_joints(made, np.random.default_rng(2))
    other.update_cfg(values)
    expected = {
        corner: (other.get_transform(f"{corner}_shank", "base") @ [0.0, 0.0, -SHANK, 1.0])[:3] for corner in CORNERS
    }
    found = dict(
        zip(made.leg_names, made.skeleton.foot_centres([values[name] for name in made.joint_names]), strict=True)
    )
    for corner, foot in expected.items():
        np.testing.assert_allclose(found[corner], foot, rtol=0.0, atol=1e-9)
