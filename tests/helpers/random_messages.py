"""Messages of any type with every field filled, and joint states with every kind of number."""

import numpy as np

from quadruped_env.ros import cdr, message_type


def filled(type_name, rng):
    """A message of a type with every field filled."""
    kind = message_type(type_name)

    def value(field):
        if field.is_message:
            return filled(field.base, rng)
        if field.base == "string":
            return "some text é"[: rng.integers(0, 12)]
        return rng.normal() if field.base == "float64" else int(rng.integers(0, 2 if field.base == "bool" else 100))

    fields = {}
    for field in kind.fields:
        count = field.count or int(rng.integers(0, 4))
        fields[field.name] = [value(field) for _ in range(count)] if field.many else value(field)
    return cdr.message(type_name, **fields)


def random_joint_states(count):
    """Arguments of `live_nodes.joint_state`: up to eight joints, numbers of any size, and NaN."""
    rng = np.random.default_rng(0)
    for i in range(count):
        joints = i % 9
        values = rng.normal(size=(3, joints)) * 10.0 ** rng.integers(-300, 300, (3, joints))
        if joints:
            values[2, 0] = np.nan
        names = [f"joint_{rng.integers(0, 10**9)}" for _ in range(joints)]
        yield int(rng.integers(0, 2**31 * 10**9)), names, *values.tolist()
