"""Message types for DDS: name and structure, with CDR bytes that are passed through unchanged.

The structure is declared so that peers can compare types. The bytes come from `quadruped_env.ros`, which also writes
bags.
"""

from functools import cache
from typing import Any

from quadruped_env.live.middleware.dds import import_dds
from quadruped_env.ros import Field, message_type


@cache
def wire_type(type_name: str) -> Any:
    """The `cyclonedds` class of a message type; an instance holds the CDR bytes of one message as `data`.

    Args:
        type_name: `package/msg/Type`.

    Raises:
        MissingExtraError: if cyclonedds is not installed.
        QuadrupedError: if the type is unknown.
    """
    import_dds()
    from cyclonedds.idl import IdlStruct, annotations, make_idl_struct

    class Carrier(IdlStruct):
        def __init__(self, data: bytes) -> None:
            self.data = data

        def serialize(self, *_: Any, **__: Any) -> bytes:
            return self.data

        @classmethod
        def deserialize(cls, data: bytes, *_: Any, **__: Any) -> Any:
            return cls(data)

        # Called for the samples that report that a publisher has left.
        deserialize_key = deserialize

    kind = message_type(type_name)
    fields = {field.name: _member(field) for field in kind.fields}
    # cyclonedds replaces every dot by `::`.
    scoped = kind.dds_name.replace("::", ".")
    made = make_idl_struct(scoped.rpartition(".")[2], scoped, fields, dataclassify=False, bases=(Carrier,))
    return annotations.final(made)


def _member(field: Field) -> Any:
    from cyclonedds.idl import types

    if field.is_message:
        base = wire_type(field.base)
    else:
        base = {"string": str, "bool": bool}.get(field.base) or getattr(types, field.base)
    if not field.many:
        return base
    return types.sequence[base] if field.count is None else types.array[base, field.count]
