"""Names of nodes and topics, with namespaces and remapping, as in ROS 2."""

import re
from dataclasses import dataclass, replace
from typing import Final, Self

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.middleware.topics import Topic

_NAME: Final = r"[A-Za-z_]\w*"
_NAMESPACE: Final = re.compile(rf"/|(/{_NAME})+")
_TOPIC: Final = re.compile(rf"(~/|/)?{_NAME}(/{_NAME})*")


@dataclass(frozen=True)
class Names:
    """Name of a node, its namespace, and its remapped topics."""

    node: str
    namespace: str = "/"
    rules: tuple[tuple[str, str], ...] = ()
    """Topics to be replaced and their replacements, as full names."""

    @classmethod
    def of(cls, node: str, namespace: str | None = None, rules: tuple[str, ...] = ()) -> Self:
        """Return the names of a node, as arguments give them.

        Args:
            node: name of the node.
            namespace: its namespace, with or without the leading slash.
            rules: `FROM:=TO` for topics.

        Raises:
            QuadrupedError: if one of them is not valid in ROS 2.
        """
        made = cls(node, f"/{(namespace or '').strip('/')}")
        if not _NAMESPACE.fullmatch(made.namespace):
            raise QuadrupedError(f"--namespace: expected names with '/' between them; found {made.namespace!r}")
        pairs = []
        for rule in rules:
            pair = rule.split(":=")
            if len(pair) != 2 or not all(map(_TOPIC.fullmatch, pair)):
                raise QuadrupedError(f"--remap: expected FROM:=TO with names of topics; found {rule!r}")
            pairs.append((made.full(pair[0]), made.full(pair[1])))
        return replace(made, rules=tuple(pairs))

    @property
    def full_node(self) -> str:
        """Namespace and name of the node."""
        return self.full(self.node)

    def full(self, name: str) -> str:
        """Return a topic's full name: without a leading slash it is in the namespace, with `~/` in the node's own."""
        if name.startswith("/"):
            return name
        if name.startswith("~/"):
            return f"{self.full_node}{name[1:]}"
        return f"{self.namespace.rstrip('/')}/{name}"

    def resolved(self, topic: Topic) -> Topic:
        """Return one of this robot's topics under the name that this node uses."""
        name = topic.name if topic.is_global else self.full(topic.name.removeprefix("/"))
        return replace(topic, name=dict(self.rules).get(name, name))
