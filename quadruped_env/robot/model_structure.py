"""Joints and feet of a robot by its model, where its author does not name them."""

from collections.abc import Mapping, Sequence
from typing import Final
from xml.etree import ElementTree

import mujoco
import numpy as np

from quadruped_env.errors import QuadrupedError, short

Place = str | Sequence[float]
"""Name of a site, or a position (3,) in the frame of a link, m."""
DIGITS: Final = 9
"""Decimals of computed lengths in m: their last bits differ between processors, and a robot's identity must not."""
_SAME_PLACE: Final = 1e-6
"""m."""


def foot_places(model: mujoco.MjModel) -> dict[str, Place]:
    """Return the centre of each foot by its link, for a robot whose first joint is free.

    In a leg's last link, and the links that are fixed to it, it is the only site, or the only ball that collides. A
    site in that ball counts only if it is the ball's centre, in the same link: touch sensors feel their own link.

    Raises:
        QuadrupedError: if a leg's last link has neither.
    """
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    solid = (model.geom_type == mujoco.mjtGeom.mjGEOM_SPHERE) & ((model.geom_contype | model.geom_conaffinity) != 0)
    places: dict[str, Place] = {}
    for last in _last_links(model):
        sites = np.flatnonzero(model.body_weldid[model.site_bodyid] == last).tolist()
        balls = np.flatnonzero((model.body_weldid[model.geom_bodyid] == last) & solid).tolist()
        if len(balls) == 1 and (len(sites) != 1 or _gap(data, sites[0], balls[0]) < model.geom_size[balls[0], 0]):
            ball, link = balls[0], model.geom_bodyid[balls[0]]
            same = [i for i in sites if model.site_bodyid[i] == link and _gap(data, i, ball) < _SAME_PLACE]
            place = model.site(same[0]).name if same else model.geom_pos[ball].round(DIGITS).tolist()
        elif len(sites) == 1:
            link = model.site_bodyid[sites[0]]
            place = model.site(sites[0]).name
        else:
            name = model.body(last).name
            raise QuadrupedError(
                f"foot_sites do not follow from its model: {name!r}, the last link of a leg, has {len(sites)} sites "
                f"and {len(balls)} balls that collide; give the centres of all feet, in the frames of their links (m): "
                f"foot_sites={{{name!r}: (x, y, z), ...}}; a joint of a neck or an arm must be removed"
            )
        places[model.body(link).name] = place
    return places


def _gap(data: mujoco.MjData, site: int, geom: int) -> float:
    """Return the distance between a site and a geom, m."""
    return float(np.linalg.norm(data.site_xpos[site] - data.geom_xpos[geom]))


def _last_links(model: mujoco.MjModel) -> list[int]:
    """Return the last body with a joint of each leg."""
    (moving,) = np.nonzero(model.body_jntnum)
    inner = model.body_weldid[model.body_parentid[moving]]
    return [int(body) for body in moving if body not in inner and body != model.jnt_bodyid[0]]


def add_sites(mjcf: str, places: Mapping[str, Place]) -> tuple[str, tuple[str, ...]]:
    """Return an MJCF with a site at each position, and the names of all sites, for places by link.

    Raises:
        QuadrupedError: if a position is not three finite numbers, or the MJCF has no such body.
    """
    if all(isinstance(place, str) for place in places.values()):
        return mjcf, tuple(map(str, places.values()))
    root = ElementTree.fromstring(mjcf)  # noqa: S314  MuJoCo has read it
    bodies = {body.get("name"): body for body in root.iter("body")}
    names = []
    for link, place in places.items():
        if isinstance(place, str):
            names.append(place)
            continue
        values = np.asarray(place, dtype=np.float64)
        if values.shape != (3,) or not np.isfinite(values).all():
            raise QuadrupedError(f"foot_sites of {link!r} must be three finite numbers (m); found {short(place)}")
        if link not in bodies:
            raise QuadrupedError(f"foot_sites: its MJCF has no body {link!r}; found {', '.join(map(str, bodies))}")
        names.append(f"foot_of_{link}")
        position = " ".join(map(repr, values.tolist()))
        ElementTree.SubElement(bodies[link], "site", name=names[-1], pos=position)
    return ElementTree.tostring(root, encoding="unicode"), tuple(names)
