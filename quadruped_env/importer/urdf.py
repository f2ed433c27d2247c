"""Reader of URDF."""

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.importer.description import FIXED, HINGE, LARGEST, Description, Joint, Link, Shape, about, named
from quadruped_env.importer.files import Folders, mesh_vertices
from quadruped_env.importer.shapes import ball, box, cylinder, mesh
from quadruped_env.importer.xml_tree import Node
from quadruped_env.utils.arrays import Floats

_KINDS: Final = {
    "revolute": HINGE,
    "continuous": HINGE,
    "prismatic": "slide",
    "fixed": FIXED,
    "floating": "free",
    "planar": "free",
}
_NO_LIMIT: Final = 1000.0
"""Range from which on limits are none, rad."""
_MAX_LINKS: Final = 2000


class Urdf:
    """Content of one URDF, on its way to a `Description`."""

    def __init__(self, root: Node, folders: Folders) -> None:
        self.root, self.folders = root, folders
        self.within = ""
        """Link or joint that is read, for errors: the lines of an expanded xacro file are not the user's."""
        self.missing: dict[str, str] = {}
        """Meshes that cannot be read, with the reason."""

    def description(self) -> Description:
        """Return the links in the order of the file's joints, parents first.

        Raises:
            QuadrupedError: if an element is missing, repeated or no number, or the links are no single tree.
        """
        links = self._named("link")
        joints = self._named("joint")
        order = self._order(links, joints)
        described = Description(self.root.get("name") or "robot", [], [])
        index = {name: i for i, (name, _) in enumerate(order)}
        for name, joint in order:
            self.within = f"in {short(name)}: "
            link = self._link(links[name])
            if joint is not None:
                self.within = f"in {short(joint.get('name'))}: "
                link.parent = index[self._reference(joint, "parent", links)]
                link.position, link.rotation = self._origin(joint)
                link.joint = self._joint(joint)
            described.links.append(link)
        _fix_loose(described)
        if not any(link.mass for link in described.links):
            self._assume_density(described)
        self._report(described, links)
        return described

    def _error(self, node: Node, message: str) -> QuadrupedError:
        return QuadrupedError(f"line {node.line}: <{node.tag}> {self.within}{message}")

    def _named(self, tag: str) -> dict[str, Node]:
        found: dict[str, Node] = {}
        for node in self.root.findall(tag):
            name = node.get("name") or ""
            if not name or len(name) > 100:
                raise self._error(node, f"needs a name of up to 100 characters; found {short(name)}")
            if name in found:
                raise self._error(
                    node, f"{short(name)} repeats the name of line {found[name].line}; rename one of them"
                )
            found[name] = node
        if tag == "link" and not 1 <= len(found) <= _MAX_LINKS:
            raise self._error(self.root, f"must have 1 to {_MAX_LINKS} links; found {len(found)}")
        return found

    def _order(self, links: dict[str, Node], joints: dict[str, Node]) -> list[tuple[str, Node | None]]:
        """Return the names of the links with the joints above them, depth first, in the order of the file's joints."""
        below: dict[str, list[tuple[str, Node]]] = {name: [] for name in links}
        above: dict[str, Node] = {}
        for joint in joints.values():
            parent, child = (self._reference(joint, role, links) for role in ("parent", "child"))
            if child in above:
                raise self._error(
                    joint, f"gives the link {short(child)} a second parent, after line {above[child].line}"
                )
            below[parent].append((child, joint))
            above[child] = joint
        roots = [name for name in links if name not in above]
        if len(roots) > 1:  # links without joints, such as leftovers, are no robots
            roots = [name for name in roots if below[name]] or roots[:1]
        if len(roots) != 1:
            what = "every link has a parent, so the joints form a circle" if not roots else f"roots are {named(roots)}"
            raise self._error(self.root, f"must have its links in one tree; {what}")
        order: list[tuple[str, Node | None]] = []
        stack: list[tuple[str, Node | None]] = [(roots[0], None)]
        while stack:
            order.append(stack.pop())
            stack.extend(reversed(below[order[-1][0]]))
        reached = {name for name, _ in order}
        if lost := [name for name in above if name not in reached]:
            raise self._error(above[lost[0]], f"the links {named(lost)} form a circle; correct a parent")
        return order

    def _reference(self, joint: Node, role: str, links: dict[str, Node]) -> str:
        name = self._one(joint, role).get("link") or ""
        if name not in links:
            raise self._error(joint, f"{short(joint.get('name'))}: its {role} {short(name)} is no link of the file")
        return name

    def _one(self, node: Node, tag: str) -> Node:
        """Return the only child of a tag, or an element without attributes where there is none."""
        found = node.findall(tag)
        if len(found) > 1:
            raise self._error(found[1], f"expected one <{tag}>; found {len(found)}")
        return found[0] if found else Node(tag, {}, node.line)

    def _numbers(
        self, node: Node, name: str, default: Sequence[float] | None = None, largest: float = LARGEST
    ) -> list[float]:
        text = node.get(name)
        if text is None and default is not None:
            return list(default)
        count = len(default) if default else 1
        try:
            values = [float(word) for word in (text or "").split()]
        except ValueError:
            values = []
        if len(values) != count or not all(abs(value) <= largest for value in values):
            expected = "a number" if count == 1 else f"{count} numbers"
            raise self._error(node, f"{name}: expected {expected}; found {short(text)}")
        return values

    def _origin(self, node: Node) -> tuple[Floats, Floats]:
        origin = self._one(node, "origin")
        roll, pitch, yaw = self._numbers(origin, "rpy", (0.0, 0.0, 0.0))
        x, y, z = np.eye(3)
        return np.array(self._numbers(origin, "xyz", (0.0, 0.0, 0.0))), about(z, yaw) @ about(y, pitch) @ about(x, roll)

    def _joint(self, node: Node) -> Joint:
        kind = _KINDS.get(node.get("type") or "")
        if kind is None:
            raise self._error(node, f"type: expected one of {', '.join(_KINDS)}; found {short(node.get('type'))}")
        axis_node, limit, mimic = self._one(node, "axis"), self._one(node, "limit"), node.findall("mimic")
        axis = np.array(self._numbers(axis_node, "xyz", (1.0, 0.0, 0.0)))
        length = float(np.linalg.norm(axis))
        if length < 1e-6 and kind in (HINGE, "slide"):
            raise self._error(axis_node, "xyz: expected a direction; found zeros")
        joint = Joint(node.get("name") or "", kind, axis / (length or 1.0))
        if mimic:
            joint.coupled_to = mimic[0].get("joint") or "another joint"
        low, high, effort, speed = (
            None if limit.get(name) is None else self._numbers(limit, name, largest=math.inf)[0]
            for name in ("lower", "upper", "effort", "velocity")
        )
        if kind != FIXED and node.get("type") != "continuous" and (low, high) != (None, None):
            low, high = low or 0.0, high or 0.0
            if low > high:
                raise self._error(limit, f"lower {low:g} is above upper {high:g}; swap them")
            if 1e-6 < high - low < _NO_LIMIT:  # exporters write 0 and 0 where nobody entered limits
                joint.low, joint.high = low, high
        joint.effort, joint.speed = effort, speed
        return joint

    def _link(self, node: Node) -> Link:
        no_joint = Joint("", FIXED, np.array([1.0, 0.0, 0.0]))
        link = Link(node.get("name") or "", -1, np.zeros(3), np.eye(3), no_joint)
        self._inertial(self._one(node, "inertial"), link)
        for tag in ("collision", "visual"):
            for part in node.findall(tag) if not link.shapes else ():
                shape = self._shape(part)
                if shape is not None:
                    shape.collides = tag == "collision"
                    link.shapes.append(shape)
        return link

    def _inertial(self, node: Node, link: Link) -> None:
        mass, inertia = self._one(node, "mass"), self._one(node, "inertia")
        link.mass = self._size(mass, "value") if node.findall("mass") else 0.0
        link.centre, rotation = self._origin(node)
        xx, xy, xz, yy, yz, zz = (
            self._numbers(inertia, name, (0.0,))[0] for name in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
        )
        link.inertia = rotation @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ rotation.T

    def _shape(self, node: Node) -> Shape | None:
        position, rotation = self._origin(node)
        for kind in self._one(node, "geometry").children:
            if kind.tag == "sphere":
                return ball(position, self._size(kind, "radius"))
            if kind.tag == "box":
                return box(position, rotation, 0.5 * np.abs(self._numbers(kind, "size", (0.0,) * 3)))
            if kind.tag in ("cylinder", "capsule"):
                return cylinder(
                    position, rotation, self._size(kind, "radius"), self._size(kind, "length"), kind.tag == "capsule"
                )
            if kind.tag == "mesh":
                return self._mesh(kind, position, rotation, node.tag == "collision")
        return None

    def _size(self, node: Node, name: str) -> float:
        """Return a number that is 0 or more."""
        (value,) = self._numbers(node, name)
        if value < 0.0:
            raise self._error(node, f"{name}: expected 0 or more; found {value:g}")
        return value

    def _mesh(self, node: Node, position: Floats, rotation: Floats, collides: bool) -> Shape | None:
        name = node.get("filename") or ""
        scale = np.array(self._numbers(node, "scale", (1.0, 1.0, 1.0)))
        try:
            return mesh(position, rotation, mesh_vertices(self.folders.find(name)) * scale)
        except QuadrupedError as error:
            if collides:
                self.missing[name] = str(error)
            return None

    def _assume_density(self, described: Description) -> None:
        """Give links a mass by their shapes where the file has no inertial at all."""
        for link in described.links:
            shapes = link.shapes
            link.mass = 1000.0 * sum(shape.volume for shape in shapes)
            if link.mass:
                link.centre = sum(shape.volume * shape.points.mean(axis=0) for shape in shapes) / link.mass * 1000.0
        total = sum(link.mass for link in described.links)
        described.add("assumed", "mass", f"{total:.4g} kg: 1000 kg/m^3, because no link has an <inertial>")

    def _report(self, described: Description, links: dict[str, Node]) -> None:
        if self.missing:
            described.add_missing(list(self.missing.values()))
        bare = [
            n.name
            for n in described.links
            if not links[n.name].findall("inertial") and links[n.name].findall("collision")
        ]
        if bare and any(links[name].findall("inertial") for name in links):
            described.add(
                "found", "mass", f"{named(bare)}: shapes without <inertial> get no mass (MuJoCo would give 1000 kg/m^3)"
            )


def _fix_loose(described: Description) -> None:
    """Fix links on floating joints below which no joint moves, such as feet that some simulators hold there."""
    carriers: set[int] = set()
    loose: list[str] = []
    for i, link in reversed(list(enumerate(described.links))):
        if link.joint.kind == "free" and i not in carriers:
            link.joint.kind = FIXED
            loose.insert(0, link.joint.name)
        if link.joint.kind != FIXED or i in carriers:
            carriers.add(link.parent)
    if loose:
        described.add("repaired", "joints", f"{named(loose)}: floating, with nothing that moves below; fixed")
