"""Files that a robot's description names: found in the folders that a user names, and only there."""

import os
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.importer.xml_tree import read_bytes
from quadruped_env.utils.arrays import Floats

MAX_MESH: Final = 60_000_000
"""Maximum size of a mesh, bytes: a million triangles."""
_LAYOUT: Final = ("urdf", "urdfs", "robots", "robot", "xacro", "mjcf", "xml")
"""Names of folders in a ROS package whose files use the folders next to them."""
_MAX_FILES: Final = 200_000
_NUMBERS: Final = rb"[ \t]+([-+.\deE]+)[ \t]+([-+.\deE]+)[ \t]+([-+.\deE]+)"
_PROTOCOL: Final = re.compile(r"^(package|model|file)://")


@dataclass
class Folders:
    """Folders in which files are searched: those that a user names, and the package of the description."""

    given: tuple[Path, ...]
    file: Path
    _index: dict[str, list[Path]] | None = field(default=None, repr=False)

    @property
    def roots(self) -> tuple[Path, ...]:
        """All folders: the package of the description, or its own folder, and the given ones."""
        return (self._package(), *(folder.resolve() for folder in self.given))

    def _package(self) -> Path:
        own = self.file.resolve().parent
        for folder in (own, *list(own.parents)[:3]):
            if (folder / "package.xml").is_file():
                return folder
        return own.parent if own.name in _LAYOUT and own.parent != Path(own.root) else own

    def contain(self, path: Path) -> bool:
        """Return True for a path in one of the folders, after all links are resolved."""
        target = path.resolve()
        return any(target.is_relative_to(root) for root in self.roots)

    def find(self, name: str, beside: tuple[Path, ...] = ()) -> Path:
        """Return the file of a name as it stands in a description.

        A relative name is searched next to the description and in `beside`, and `package://NAME/...` below every folder
        by the end of its path.

        Raises:
            QuadrupedError: if there is no such file, or in none of the folders.
        """
        tail = _PROTOCOL.sub("", name).replace("\0", "").replace("\\", "/")  # of Windows
        if not name.startswith(("package://", "model://")):
            for place in [folder / tail for folder in (self.file.parent, *beside)]:  # an absolute name replaces them
                if os.path.isfile(place):
                    if self.contain(place):
                        return place
                    raise QuadrupedError(
                        f"{name!r} is outside the folders that are searched; name its folder with --folder"
                    )
        parts = [part for part in tail.split("/") if part not in ("", ".", "..")]
        known = [path for path in self._paths().get(parts[-1], []) if not path.is_dir()] if parts else []
        if not known:
            raise QuadrupedError(f"{name!r} is not found; name its folder with --folder")
        return max(known, key=lambda path: _common_end(path.parts, parts))

    def package(self, name: str) -> Path:
        """Return the folder of a ROS package: one of that name, or one whose package.xml has that name.

        Raises:
            QuadrupedError: if there is none.
        """
        element = f"<name>{name}</name>".encode()
        for place in (*self._paths().get(name, []), *self._paths().get("package.xml", [])):
            if place.name == name and place.is_dir():
                return place
            if place.name == "package.xml" and element in read_bytes(place).replace(b" ", b""):
                return place.parent
        raise QuadrupedError(
            f"the package {short(name)} is not found: no folder has that name, or a package.xml with it; name its "
            f"folder with --folder"
        )

    def _paths(self) -> dict[str, list[Path]]:
        """Return the files and folders below all roots by their names, but for hidden folders."""
        if self._index is None:
            self._index, seen = {}, 0
            for root in self.roots:
                for place, folders, names in os.walk(root):
                    folders[:] = [name for name in sorted(folders) if not name.startswith(".")]
                    for path in (Path(place), *(Path(place, name) for name in sorted(names))):
                        self._index.setdefault(path.name, []).append(path)
                    seen += len(names) + 1
                    if seen > _MAX_FILES:
                        raise QuadrupedError(
                            f"{root}: has over {_MAX_FILES} files; name the robot's own folder with --folder"
                        )
        return self._index


def _common_end(path: tuple[str, ...], parts: list[str]) -> int:
    """Return the number of names in which the ends of two paths agree."""
    count = 0
    for a, b in zip(reversed(path), reversed(parts), strict=False):
        if a != b:
            break
        count += 1
    return count


def mesh_vertices(path: Path) -> Floats:
    """Return the vertices (P, 3) of an STL or an OBJ file.

    Raises:
        QuadrupedError: if it is too large, another format, or holds no finite vertices.
    """
    kind = path.suffix.lower()
    if kind not in (".stl", ".obj"):
        raise QuadrupedError(f"{path.name}: {kind or 'a file without suffix'} is not read; STL and OBJ are")
    content = read_bytes(path, "simplify the mesh", MAX_MESH)
    if kind == ".obj":
        found = _text_vertices(content, rb"^v")
    else:
        count = int.from_bytes(content[80:84], "little")
        if len(content) >= 84 + 50 * count and count:
            triangles = np.frombuffer(content, np.uint8, 50 * count, 84).reshape(count, 50)[:, 12:48]
            found = np.ascontiguousarray(triangles).view("<f4").reshape(-1, 3).astype(np.float64)
        else:
            found = _text_vertices(content, rb"^[ \t]*vertex")
    if len(found) < 4 or not np.isfinite(found).all() or np.abs(found).max() > 1e6:
        raise QuadrupedError(f"{path.name}: has fewer than four vertices, or infinite ones")
    return found


def _text_vertices(content: bytes, word: bytes) -> Floats:
    try:
        found = [[float(x) for x in match] for match in re.findall(word + _NUMBERS, content, re.MULTILINE)]
    except ValueError:
        return np.zeros((0, 3))
    return np.array(found).reshape(-1, 3)
