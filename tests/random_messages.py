"""Messages of any type with something in every field."""

from quadruped_env.ros import MESSAGE_TYPES, cdr


def filled(type_name, rng):
    """A message of a type with something in every field."""
    kind = MESSAGE_TYPES[type_name]

    def value(field):
        if field.is_message:
            return filled(field.base, rng)
        if field.base == "string":
            return "some text é"[: rng.integers(0, 12)]
        return rng.normal() if field.base == "float64" else int(rng.integers(0, 10**9))

    fields = {}
    for field in kind.fields:
        count = field.count or int(rng.integers(0, 4))
        fields[field.name] = [value(field) for _ in range(count)] if field.many else value(field)
    return cdr.message(type_name, **fields)
