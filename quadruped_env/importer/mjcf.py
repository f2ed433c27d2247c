"""Reader of MJCF, by MuJoCo."""

import math
import os
import warnings
from typing import Final

import mujoco
import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.importer.description import FIXED, HINGE, LARGEST, Description, Joint, Link, Shape
from quadruped_env.importer.files import MAX_MESH, Folders
from quadruped_env.importer.shapes import ball, box, cylinder, mesh
from quadruped_env.importer.xml_tree import Node, parse, read_bytes
from quadruped_env.utils.arrays import Floats

_GEOM: Final = mujoco.mjtGeom
_KINDS: Final = ("free", "ball", "slide", HINGE)
"""By MuJoCo's number of a joint's type."""
_NUMBERS: Final = (
    *("body_pos", "body_quat", "body_ipos", "body_iquat", "body_mass", "body_inertia", "jnt_pos", "jnt_axis"),
    *("jnt_range", "geom_pos", "geom_quat", "geom_size", "key_qpos", "dof_armature"),
)
"""Arrays of a model that are read."""
_LEAST: Final = 1e-9, 1e-14
"""Mass and inertia that MuJoCo gives a link without them, kg and kg m^2: it refuses zero."""
_EQUALITY: Final = mujoco.mjtEq
_ON_JOINT: Final = (mujoco.mjtTrn.mjTRN_JOINT, mujoco.mjtTrn.mjTRN_JOINTINPARENT)


def describe_mjcf(content: bytes, root: Node, folders: Folders) -> Description:
    """Return the content of an MJCF.

    Raises:
        QuadrupedError: if MuJoCo cannot read it, or it includes a file outside the folders.
    """
    described = Description(root.get("model") or "robot", [], [])
    files: dict[str, bytes] = {}
    _read_includes(root, folders, files)
    try:
        spec = mujoco.MjSpec.from_string(content.decode("utf-8-sig", errors="replace"), include=files)
        missing = _load_meshes(spec, folders)
        given = _impossible_inertia(spec)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of a singular inertia
            model = spec.compile()
    except (ValueError, mujoco.FatalError) as error:
        raise QuadrupedError(f"MuJoCo cannot read it ({' '.join(str(error).split())}); correct the file") from error
    if missing:
        described.add_missing(missing)
    _check_finite(model)
    _links(model, described, {body.id: inertia for body, inertia in given})
    _report(model, described)
    return described


def _check_finite(model: mujoco.MjModel) -> None:
    for name in _NUMBERS:
        values = getattr(model, name)
        if not (np.abs(values) <= LARGEST).all():  # NaN compares as false
            raise QuadrupedError(f"{name} of its model has a number that is NaN or over {LARGEST:g}; correct it")


def _read_includes(root: Node, folders: Folders, files: dict[str, bytes], where: str = "") -> None:
    """Add the files that one includes, and refuse what would fill the memory, or never end, while MuJoCo reads them."""
    for node in root.iter():
        place = f"{where}line {node.line}: <{node.tag[:40]}>"
        for name in ("nrow", "ncol", "count"):
            found = node.get(name) or ""
            if any(len(word) > 4 for word in found.split()):
                raise QuadrupedError(f"{place} {name}: expected numbers below 10000; found {short(found)}")
        if node.tag == "replicate" and sum(inner.tag == "replicate" for inner in node.iter()) > 1:
            raise QuadrupedError(f"{place} contains another; write the bodies out")
        name = node.get("file") or ""
        if node.tag == "include" and name not in files:
            try:
                files[name] = read_bytes(folders.find(name))
            except QuadrupedError as error:
                raise QuadrupedError(f"{place} {error}") from error
            _read_includes(parse(files[name], f"{name}: "), folders, files, f"{name}: ")


def _load_meshes(spec: mujoco.MjSpec, folders: Folders) -> list[str]:
    """Load the meshes that collide or give a mass, and delete all others; return why some are missing."""
    inferred = {body.name for body in spec.bodies if not body.explicitinertial}
    used: set[str] = set()
    missing: dict[str, str] = {}
    assets: dict[str, bytes] = {}
    meshes = {_mesh_name(entry): entry for entry in spec.meshes}
    for shown in (*spec.geoms, *spec.sites, *spec.tendons):
        shown.material = ""
    for geom in list(spec.geoms):
        if geom.type in (_GEOM.mjGEOM_HFIELD, _GEOM.mjGEOM_SDF):
            spec.delete(geom)
        elif geom.meshname:
            name, needed = geom.meshname, geom.contype or geom.conaffinity or geom.parent.name in inferred
            if needed and name not in used and name not in missing:
                problem = _load(meshes.get(name), spec, folders, assets)
                if problem:
                    missing[name] = problem
                else:
                    used.add(name)
            if not needed or name in missing:
                spec.delete(geom)
    for entry in list(spec.meshes):
        if _mesh_name(entry) not in used:
            spec.delete(entry)
    for entries in (spec.skins, spec.hfields, spec.materials, spec.textures, spec.flexes):
        for entry in list(entries):
            spec.delete(entry)
    spec.assets = assets
    return list(missing.values())


def _mesh_name(entry: mujoco.MjsMesh) -> str:
    return entry.name or os.path.splitext(os.path.basename(entry.file))[0]


def _load(entry: mujoco.MjsMesh | None, spec: mujoco.MjSpec, folders: Folders, assets: dict[str, bytes]) -> str:
    """Add the content of a mesh's file to the assets; return why that is impossible, or nothing."""
    if entry is None or not entry.file:
        return "" if entry is not None else "it is not declared"
    directory = spec.compiler.meshdir or spec.modelfiledir or ""
    try:
        path = folders.find(os.path.join(spec.compiler.meshdir or "", entry.file), (folders.file.parent / directory,))
        content = read_bytes(path, "simplify the mesh", MAX_MESH)
        alone = mujoco.MjSpec()
        alone.assets = {f"mesh{path.suffix.lower()}": content}
        alone.add_mesh(name="mesh", file=f"mesh{path.suffix.lower()}", scale=entry.scale)
        alone.worldbody.add_geom(type=_GEOM.mjGEOM_MESH, meshname="mesh")
        alone.compile()
    except (QuadrupedError, ValueError, mujoco.FatalError) as error:
        return " ".join(str(error).split())
    entry.name = entry.name or _mesh_name(entry)
    name = f"mesh_{len(assets)}{path.suffix.lower()}"
    entry.file, assets[name] = name, content
    return ""


def _impossible_inertia(spec: mujoco.MjSpec) -> list[tuple[mujoco.MjsBody, Floats]]:
    """Give bodies whose inertia MuJoCo refuses another one; return them with theirs (3, 3), for `inertia.repair`."""
    spec.compiler.boundmass = max(spec.compiler.boundmass, _LEAST[0])
    spec.compiler.boundinertia = max(spec.compiler.boundinertia, _LEAST[1])
    found = []
    for body in spec.bodies[1:]:
        if (
            not body.explicitinertial
            or spec.compiler.inertiafromgeom == mujoco.mjtInertiaFromGeom.mjINERTIAFROMGEOM_TRUE
        ):
            continue
        turn = np.zeros(9)
        mujoco.mju_quat2Mat(turn, body.iquat / (np.linalg.norm(body.iquat) or 1.0))
        xx, yy, zz, xy, xz, yz = body.fullinertia
        full = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        inertia = np.diag(body.inertia) if np.isnan(full).any() else full
        inertia = turn.reshape(3, 3) @ inertia @ turn.reshape(3, 3).T
        if not np.isfinite(inertia).all():
            continue
        moments = np.linalg.eigvalsh(inertia)
        if moments[0] <= 0.0 or 2.0 * moments[2] > moments.sum():
            found.append((body, inertia))
            body.fullinertia, body.inertia = [math.nan] * 6, [1.0] * 3
    return found


def _links(model: mujoco.MjModel, described: Description, given: dict[int, Floats]) -> None:
    """Add the links of a compiled model, in the poses of joint positions 0, with the inertia (3, 3) of some bodies."""
    data = mujoco.MjData(model)
    data.qpos[:] = 0.0
    for joint in range(model.njnt):
        kind = _KINDS[model.jnt_type[joint]]
        if kind in ("free", "ball"):
            data.qpos[model.jnt_qposadr[joint] + (3 if kind == "free" else 0)] = 1.0
    mujoco.mj_kinematics(model, data)
    coupled = _coupled(model)
    efforts = _efforts(model)
    last_link = {0: -1}
    poses: list[tuple[Floats, Floats]] = []
    for body in range(1, model.nbody):
        first = model.body_jntadr[body]
        joints = list(range(first, first + model.body_jntnum[body])) if first >= 0 else []
        own = data.xmat[body].reshape(3, 3).copy()
        parent = last_link[int(model.body_parentid[body])]
        name = model.body(body).name or f"body_{body}"
        for place, joint in enumerate(joints or [-1]):
            final = place == max(len(joints) - 1, 0)
            hinged = joint >= 0 and _KINDS[model.jnt_type[joint]] in (HINGE, "slide")
            origin = data.xanchor[joint].copy() if hinged else data.xpos[body].copy()
            link = Link(name if final else f"{name}_{place + 1}", parent, origin, own, _joint(model, data, joint, own))
            if joint >= 0:
                link.joint.coupled_to = coupled.get(joint, "")
                link.joint.effort = efforts.get(joint)
            if parent >= 0:
                place_of, turn = poses[parent]
                link.position, link.rotation = turn.T @ (origin - place_of), turn.T @ own
            if final:
                _fill(model, data, body, link, origin, own)
                link.inertia = given.get(body, link.inertia)
            parent = len(described.links)
            described.links.append(link)
            poses.append((origin, own))
        last_link[body] = parent
    for site in range(model.nsite):  # frames, as of feet whose meshes are missing
        parent = last_link[int(model.site_bodyid[site])]
        if parent >= 0:
            place_of, turn = poses[parent]
            position = turn.T @ (data.site_xpos[site] - place_of)
            fixed = Joint("", FIXED, np.array([1.0, 0.0, 0.0]))
            described.links.append(Link(f"site {model.site(site).name}", parent, position, np.eye(3), fixed))
    described.home = _home(model)


def _joint(model: mujoco.MjModel, data: mujoco.MjData, joint: int, own: Floats) -> Joint:
    if joint < 0:
        return Joint("", FIXED, np.array([1.0, 0.0, 0.0]))
    axis = own.T @ data.xaxis[joint]
    kind = _KINDS[model.jnt_type[joint]]
    found = Joint(model.joint(joint).name or f"joint_{joint}", kind, axis / (np.linalg.norm(axis) or 1.0))
    if model.jnt_limited[joint] and kind in (HINGE, "slide"):
        found.low, found.high = map(float, model.jnt_range[joint])
    found.armature = float(model.dof_armature[model.jnt_dofadr[joint]])
    return found


def _fill(model: mujoco.MjModel, data: mujoco.MjData, body: int, link: Link, origin: Floats, own: Floats) -> None:
    """Give a link the mass, inertia and shapes of a body."""
    link.mass = float(model.body_mass[body])
    turn = own.T @ data.ximat[body].reshape(3, 3)
    link.centre = own.T @ (data.xipos[body] - origin)
    link.inertia = turn @ np.diag(model.body_inertia[body]) @ turn.T
    for geom in range(model.body_geomadr[body], model.body_geomadr[body] + model.body_geomnum[body]):
        shape = _shape(model, geom, own.T @ (data.geom_xpos[geom] - origin), own.T @ data.geom_xmat[geom].reshape(3, 3))
        if shape is not None:
            shape.collides = bool(model.geom_contype[geom] or model.geom_conaffinity[geom])
            link.shapes.append(shape)


def _shape(model: mujoco.MjModel, geom: int, position: Floats, rotation: Floats) -> Shape | None:
    kind, size = mujoco.mjtGeom(model.geom_type[geom]), model.geom_size[geom]
    if kind == _GEOM.mjGEOM_SPHERE:
        return ball(position, float(size[0]))
    if kind in (_GEOM.mjGEOM_CAPSULE, _GEOM.mjGEOM_CYLINDER):
        return cylinder(position, rotation, float(size[0]), 2.0 * float(size[1]), kind == _GEOM.mjGEOM_CAPSULE)
    if kind in (_GEOM.mjGEOM_BOX, _GEOM.mjGEOM_ELLIPSOID):
        return box(position, rotation, size)
    if kind == _GEOM.mjGEOM_MESH:
        first, count = model.mesh_vertadr[model.geom_dataid[geom]], model.mesh_vertnum[model.geom_dataid[geom]]
        return mesh(position, rotation, model.mesh_vert[first : first + count].astype(np.float64))
    return None


def _coupled(model: mujoco.MjModel) -> dict[int, str]:
    """Return the joints whose positions follow others', by their index."""
    found = {}
    for i in range(model.neq):
        if model.eq_type[i] == _EQUALITY.mjEQ_JOINT and model.eq_obj2id[i] >= 0:
            found[int(model.eq_obj1id[i])] = model.joint(model.eq_obj2id[i]).name
    return found


def _efforts(model: mujoco.MjModel) -> dict[int, float]:
    """Return the torques that limits of joints and actuators allow, by the joint's index, N m."""
    found = {}
    for joint in range(model.njnt):
        if model.jnt_actfrclimited[joint]:
            found[joint] = float(np.abs(model.jnt_actfrcrange[joint]).max())
    for i in range(model.nu):
        joint, gear = int(model.actuator_trnid[i, 0]), abs(float(model.actuator_gear[i, 0]))
        if mujoco.mjtTrn(model.actuator_trntype[i]) not in _ON_JOINT or joint in found:
            continue
        direct = model.actuator_biastype[i] == mujoco.mjtBias.mjBIAS_NONE
        if model.actuator_forcelimited[i]:
            found[joint] = gear * float(np.abs(model.actuator_forcerange[i]).max())
        elif direct and model.actuator_ctrllimited[i]:
            found[joint] = gear * abs(
                float(model.actuator_gainprm[i, 0]) * float(np.abs(model.actuator_ctrlrange[i]).max())
            )
    return found


def _home(model: mujoco.MjModel) -> dict[str, float] | None:
    """Return the joint positions of the keyframe `home`, or of the first that is not all zeros."""
    keys = [
        k
        for k in range(model.nkey)
        if np.abs(model.key_qpos[k][7:] if model.nq > 7 else model.key_qpos[k]).max() > 1e-6
    ]
    keys.sort(key=lambda k: model.key(k).name != "home")
    if not keys:
        return None
    hinges = [j for j in range(model.njnt) if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_HINGE]
    return {model.joint(j).name: float(model.key_qpos[keys[0], model.jnt_qposadr[j]]) for j in hinges}


def _report(model: mujoco.MjModel, described: Description) -> None:
    described.loops = [
        (model.body(model.eq_obj1id[i]).name, model.body(model.eq_obj2id[i]).name)
        for i in range(model.neq)
        if mujoco.mjtEq(model.eq_type[i]) in (_EQUALITY.mjEQ_CONNECT, _EQUALITY.mjEQ_WELD)
        and model.eq_objtype[i] == mujoco.mjtObj.mjOBJ_BODY
    ]
    ground = model.body_geomnum[0]
    for count, what, why in (
        (int(ground), "ground", "of the world's geoms; the task has its own"),
        (model.nu, "actuators", "of the file; the motors take their place"),
        (model.nsensor, "sensors", "of the file; the robot gets its own"),
    ):
        if count:
            described.add("left out", what, f"{count} {why}")
