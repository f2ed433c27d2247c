"""Quality-of-service profiles for `cyclonedds`, and their compatibility."""

from typing import Any, Final

from quadruped_env.ros import MessageType, Qos

_BLOCKING: Final = 100_000_000
"""Maximum time that a reliable writer blocks on a slow reader, the DDS default, ns."""


def dds_qos(qos: Qos, kind: MessageType, ignore_own: bool = False) -> Any:
    """The DDS QoS for an endpoint; its user data carries the type hash, as in ROS 2 Iron and later.

    Args:
        qos: the profile.
        kind: the message type.
        ignore_own: ignore endpoints of the same participant.
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
    """The profile of a discovered endpoint; depth 0 means keep all."""
    from cyclonedds.core import Policy

    policies = {policy.__scope__: policy for policy in qos}
    return Qos(
        depth=getattr(policies.get("History"), "depth", 0),
        reliable=isinstance(policies.get("Reliability"), Policy.Reliability.Reliable),
        transient_local=policies.get("Durability") not in (None, Policy.Durability.Volatile),
    )


def read_type_hash(qos: Any) -> str:
    """The type hash in the user data of a discovered endpoint; empty if it has none."""
    for policy in qos:
        if policy.__scope__ == "Userdata":
            for entry in policy.data.decode("ascii", "replace").split(";"):
                key, _, value = entry.strip().partition("=")
                if key == "typehash":
                    return str(value)
    return ""


def incompatible(offered: Qos, requested: Qos) -> str:
    """The reason why a reader receives nothing from a writer; empty if the profiles are compatible."""
    reasons = []
    if requested.reliable and not offered.reliable:
        reasons.append("the reader requests reliable delivery, the writer offers best effort")
    if requested.transient_local and not offered.transient_local:
        reasons.append("the reader requests transient local (latched), the writer offers volatile")
    return " and ".join(reasons)
