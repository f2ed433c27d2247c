"""Qualities of service for `cyclonedds`, and what keeps two ends of a topic apart, in words."""

from typing import Any, Final

from quadruped_env.ros import MessageType, Qos

_BLOCKING: Final = 100_000_000
"""ns that a reliable writer waits for a slow reader, which is what DDS takes by default"""


def dds_qos(qos: Qos, kind: MessageType, ignore_own: bool = False) -> Any:
    """What an endpoint is created with; its user data carries the type hash, as ROS 2 does from Iron on.

    Args:
        qos: the profile.
        kind: the type of its messages.
        ignore_own: whether it is kept apart from what the same participant has.
    """
    from cyclonedds.core import Policy
    from cyclonedds.core import Qos as DdsQos

    return DdsQos(
        Policy.Reliability.Reliable(_BLOCKING) if qos.reliable else Policy.Reliability.BestEffort,
        Policy.Durability.TransientLocal if qos.transient_local else Policy.Durability.Volatile,
        Policy.History.KeepLast(qos.depth),
        Policy.IgnoreLocal.Participant if ignore_own else Policy.IgnoreLocal.Nothing,
        Policy.Userdata(f"typehash={kind.type_hash};".encode()),
    )


def read_qos(qos: Any) -> Qos:
    """The profile of an endpoint that was discovered; a depth of 0 keeps all."""
    from cyclonedds.core import Policy

    policies = {policy.__scope__: policy for policy in qos}
    return Qos(
        depth=getattr(policies.get("History"), "depth", 0),
        reliable=isinstance(policies.get("Reliability"), Policy.Reliability.Reliable),
        transient_local=policies.get("Durability") not in (None, Policy.Durability.Volatile),
    )


def read_type_hash(qos: Any) -> str:
    """The type hash in the user data of an endpoint that was discovered; empty where it has none."""
    for policy in qos:
        if policy.__scope__ == "Userdata":
            for entry in policy.data.decode("ascii", "replace").split(";"):
                key, _, value = entry.strip().partition("=")
                if key == "typehash":
                    return str(value)
    return ""


def incompatible(offered: Qos, requested: Qos) -> str:
    """Why a reader gets nothing from a writer, in words; empty if it does."""
    reasons = []
    if requested.reliable and not offered.reliable:
        reasons.append("the reader asks for reliable delivery, the writer offers best effort")
    if requested.transient_local and not offered.transient_local:
        reasons.append("the reader asks for transient local (latched), the writer offers volatile")
    return " and ".join(reasons)
