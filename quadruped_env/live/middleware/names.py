"""Names of nodes and topics, with namespaces and remapping, as in ROS 2."""

import re
from dataclasses import dataclass, replace
from typing import Final, Self

from quadruped_env.errors import QuadrupedError
from quadruped_env.live.middleware.topics import Topic

_NAME: Final = r"[A-Za-z_]\w*"
_NODE: Final = re.compile(_NAME)
_NAMESPACE: Final = re.compile(rf"/|(/{_NAME})+")
_TOPIC: Final = re.compile(rf"(~/|/)?{_NAME}(/{_NAME})*")
_RULE: Final = "FROM:=TO"


@dataclass(frozen=True)
class Names:
    """The name of a node, its namespace, and the topics that it uses in place of others."""

    node: str
    namespace: str = "/"
    rules: tuple[tuple[str, str], ...] = ()
    """Topics to be replaced and their replacements, as full names."""

    @classmethod
    def of(cls, node: str, namespace: str | None = None, rules: tuple[str, ...] = ()) -> Self:
        """The names of a node, as arguments give them.

        Args:
            node: name of the node.
            namespace: its namespace, with or without the leading slash.
            rules: `FROM:=TO` for topics, `__node:=NAME` and `__ns:=NAMESPACE`, each as `NODE:FROM:=TO` for one node.

        Raises:
            QuadrupedError: if one of them is not valid in ROS 2.
        """
        pairs = []
        for rule in rules:
            left, mark, right = rule.partition(":=")
            if not mark or not left or not right:
                raise QuadrupedError(f"--remap: expected {_RULE}; found {rule!r}")
            only, _, name = left.rpartition(":")
            if only in ("", node):
                pairs.append((name, right))
        special = dict(pair for pair in pairs if pair[0].startswith("__"))
        made = cls(
            special.get("__node", special.get("__name", node)),
            f"/{(special.get('__ns') or namespace or '').strip('/')}",
        )
        if not _NODE.fullmatch(made.node):
            raise QuadrupedError(f"--remap __node: expected letters, digits and '_'; found {made.node!r}")
        if not _NAMESPACE.fullmatch(made.namespace):
            raise QuadrupedError(f"--namespace: expected names with '/' between them; found {made.namespace!r}")
        topics = [pair for pair in pairs if not pair[0].startswith("__")]
        for name in (name for pair in topics for name in pair):
            if not _TOPIC.fullmatch(name):
                raise QuadrupedError(f"--remap: {name!r} is not the name of a topic; expected {_RULE}")
        return replace(made, rules=tuple((made.full(one), made.full(other)) for one, other in topics))

    @property
    def full_node(self) -> str:
        """Namespace and name of the node."""
        return self.full(self.node)

    def full(self, name: str) -> str:
        """A topic's full name; one without a leading slash is in the namespace, one with `~/` in that of the node."""
        if name.startswith("/"):
            return name
        if name.startswith("~/"):
            return f"{self.full_node}{name[1:]}"
        return f"{self.namespace.rstrip('/')}/{name}"

    def resolved(self, topic: Topic) -> Topic:
        """One of this robot's topics under the name that this node uses."""
        name = topic.name if topic.is_global else self.full(topic.name.removeprefix("/"))
        return replace(topic, name=dict(self.rules).get(name, name))
