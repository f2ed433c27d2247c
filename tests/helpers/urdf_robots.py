"""Small four-legged robots as URDF, with parts that a test replaces; lengths in m, masses in kg."""

from quadruped_env.importer import import_robot

CORNERS = {"LF": (1, 1), "RF": (1, -1), "LH": (-1, 1), "RH": (-1, -1)}
THIGH, SHANK, RADIUS = 0.2, 0.18, 0.02
LENGTH, WIDTH, SIDE = 0.4, 0.2, 0.06
"""Distances of the hips along and across the body, and of the roll and the pitch axis of a leg."""
MASS = 4.0 + 4 * (0.3 + 0.4 + 0.2)
"""Mass with three joints per leg."""


def inertial(mass, size=0.1):
    moment = mass * size**2 / 6.0
    return (
        f'<inertial><origin xyz="0 0 -0.01"/><mass value="{mass}"/><inertia ixx="{moment}" iyy="{moment}" '
        f'izz="{moment}" ixy="0" ixz="0" iyz="0"/></inertial>'
    )


def link(name, mass=0.0, shapes=""):
    return f'<link name="{name}">{inertial(mass) if mass else ""}{shapes}</link>\n'


def collision(shape, xyz="0 0 0"):
    return f'<collision><origin xyz="{xyz}"/><geometry>{shape}</geometry></collision>'


def joint(name, parent, child, xyz, axis="0 1 0", limit='lower="-1.5" upper="1.5" effort="20" velocity="15"', kind=""):
    kind = kind or ("fixed" if not axis else "revolute")
    axis = f'<axis xyz="{axis}"/>' if axis else ""
    limit = f"<limit {limit}/>" if limit and axis else ""
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}"/>{axis}{limit}</joint>\n'
    )


KNEE = 'lower="-2.6" upper="-0.2" effort="20" velocity="15"'
FOOT = collision(f'<sphere radius="{RADIUS}"/>', f"0 0 {-SHANK}")


def leg(corner, joints=3, name="{}_{}", **parts):
    """One leg; `parts` replace its texts: `foot`, `knee` (limits), `hip` (limits), `axis` (of the knee), `shank`."""
    x, y = CORNERS[corner]
    names = [name.format(corner, part) for part in ("roll", "hip", "knee")]
    roll = (
        link(f"{corner}_shoulder", 0.3)
        + joint(names[0], "base", f"{corner}_shoulder", f"{x * LENGTH / 2} {y * WIDTH / 2} 0", "1 0 0")
        if joints == 3
        else ""
    )
    start = f"0 {y * SIDE} 0" if joints == 3 else f"{x * LENGTH / 2} {y * (WIDTH / 2 + SIDE)} 0"
    hip = parts.get("hip", 'lower="-1.5" upper="1.5" effort="20" velocity="15"')
    return (
        roll
        + link(f"{corner}_thigh", 0.4)
        + joint(names[1], f"{corner}_shoulder" if joints == 3 else "base", f"{corner}_thigh", start, limit=hip)
        + parts.get("shank", link(f"{corner}_shank", 0.2, parts.get("foot", FOOT)))
        + joint(
            names[2],
            f"{corner}_thigh",
            f"{corner}_shank",
            f"0 0 {-THIGH}",
            parts.get("axis", "0 1 0"),
            limit=parts.get("knee", KNEE),
        )
    )


def robot(joints=3, base=None, extra="", order=("RH", "LF", "RF", "LH"), name="made", **parts):
    """A robot whose legs are in an order of their own; `extra` is added to it."""
    box = collision('<box size="0.4 0.2 0.1"/>')
    legs = "".join(leg(corner, joints, **parts) for corner in order)
    return f'<robot name="{name}">\n{base or link("base", 4.0, box)}{legs}{extra}</robot>\n'


def imported(text, folder, name="made.urdf", **options):
    """The robot of a text."""
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return import_robot(path, **options)


def findings(robot, status="", subject=""):
    """Texts of a robot's findings."""
    return [
        finding.text
        for finding in robot.findings
        if status in (finding.status, "") and subject in (finding.subject, "")
    ]
