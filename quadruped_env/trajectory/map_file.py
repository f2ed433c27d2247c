"""Tables of map files: their keys, and the checks of their values."""

from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, Union, get_args, get_origin, get_type_hints

import numpy as np

from quadruped_env.errors import QuadrupedError, short
from quadruped_env.utils.documents import fitted, read_toml


def read_table(path: str | Path, key: str) -> dict[str, Any]:
    """Read a table of a TOML file. Raises a QuadrupedError if the file cannot be read or lacks it."""
    table = read_toml(Path(path)).get(key)
    if not isinstance(table, dict):
        found = "none" if table is None else short(table)
        raise QuadrupedError(f"{path}: expected a table [{key}]; found {found}")
    return table


def check_keys(table: Any, form: type, where: str) -> None:
    """Raise a QuadrupedError unless it is a table whose keys are fields of a dataclass."""
    if not isinstance(table, dict):
        raise QuadrupedError(f"{where}: expected a table; found {short(table)}")
    known = [field.name for field in fields(form) if field.name != "name"]
    for key in table:
        if key not in known:
            raise QuadrupedError(f"{where}: unknown key {short(key)}; known are {', '.join(known)}")


def check_forms(where: str, given: object) -> None:
    """Raise a QuadrupedError for the first field of a dataclass whose value does not fit its annotation."""
    for key, form in get_type_hints(type(given)).items():
        value = getattr(given, key)
        value = value.item() if isinstance(value, np.generic) else value
        forms = get_args(form) if get_origin(form) in (UnionType, Union) else (form,)
        if value is None and NoneType in forms:
            continue
        problems = []
        for one in forms:
            try:
                if one is not NoneType:
                    fitted(value, one, f"{where} {key}", "fix it")
                    break
            except QuadrupedError as error:
                problems.append(error)
        else:
            raise problems[0]


def check_values(where: str, given: object, expected: Mapping[str, tuple[str, object]]) -> None:
    """Raise a QuadrupedError for the first field that is not as expected: field -> description, whether it holds."""
    for key, (wanted, holds) in expected.items():
        if not holds:
            raise QuadrupedError(f"{where} {key}: expected {wanted}; found {short(getattr(given, key))}")
