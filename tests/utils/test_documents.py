"""Structured files: their contents, their limits, their forms, and short error messages."""

import math
from typing import Any, ClassVar, Literal, NotRequired, TypedDict

import pytest

from quadruped_env import QuadrupedError
from quadruped_env.errors import MAX_MESSAGE, cut, short
from quadruped_env.utils.documents import MAX_BYTES, fitted, read_json, read_toml

MEGABYTES = "x" * 4_800_000


class TestDocuments:
    def test_read_json_and_toml_returns_their_contents(self, tmp_path):
        path = tmp_path / "a"
        path.write_bytes(b'\xef\xbb\xbf{"a": [1, 2.5, null, {"b": "\xc3\xa4"}]}')
        assert read_json(path) == {"a": [1, 2.5, None, {"b": "ä"}]}
        path.write_text("a.b.'c.d' = [1, 2.5]\n# a.b.c.d.e is no key\n")
        assert read_toml(path) == {"a": {"b": {"c.d": [1, 2.5]}}}

    def test_read_json_of_too_many_bytes_is_refused(self, tmp_path):
        path = tmp_path / "a.json"
        with path.open("wb") as file:
            file.truncate(MAX_BYTES["JSON"] + 1)
        with pytest.raises(QuadrupedError, match=rf"a\.json: over {MAX_BYTES['JSON']} bytes are too many"):
            read_json(path)


class Inner(TypedDict):
    a: float | None
    b: NotRequired[list[int]]


class Outer(TypedDict):
    version: Literal[1]
    inner: dict[str, Inner]
    text: Inner | None
    free: Any


class TestForms:
    SOUND: ClassVar = {
        "version": 1,
        "inner": {"x": {"a": 1, "b": [1, 2]}, "y": {"a": None}},
        "text": {"a": 1},
        "free": [{}],
    }

    def test_fitted_leaves_out_what_the_form_lacks(self):
        other = {**self.SOUND, "later": 1, "inner": {"x": {"a": 1, "b": [1, 2], "c": {}}, "y": {"a": None}}}
        assert fitted(self.SOUND, Outer, "file", "fix it") == self.SOUND
        assert fitted(other, Outer, "file", "fix it") == self.SOUND

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"version": 2}, "version: expected 1; found 2; fix it"),
            ({"version": True}, "version: expected 1; found True; fix it"),
            ({"inner": [1]}, r"inner: expected a table; found \[1\]; fix it"),
            ({"inner": {"x": {}}}, r"inner\.x\.a is missing; fix it"),
            ({"inner": {"x": {"a": "1"}}}, r"inner\.x\.a: expected a finite number or null; found '1'; fix it"),
            ({"inner": {"x": {"a": math.nan}}}, r"inner\.x\.a: expected a finite number or null; found nan; fix it"),
            ({"inner": {"x": {"a": True}}}, r"inner\.x\.a: expected a finite number or null; found True; fix it"),
            ({"inner": {"x": {"a": 10**300}}}, r"inner\.x\.a: expected a finite number or null; found 1000.*; fix it"),
            ({"inner": {"x": {"a": 1, "b": [1, 1.5]}}}, r"inner\.x\.b\.1: expected a whole number; found 1\.5; fix it"),
            ({"text": 3}, "text: expected a table or null; found 3; fix it"),
            ({"text": {"a": "x"}}, r"text\.a: expected a finite number or null; found 'x'; fix it"),
        ],
    )
    def test_fitted_names_file_field_value_and_fix(self, change, message):
        with pytest.raises(QuadrupedError, match=rf"^file: {message}$"):
            fitted({**self.SOUND, **change}, Outer, "file", "fix it")

    def test_fitted_refuses_what_is_no_table(self):
        with pytest.raises(QuadrupedError, match=r"^file: expected a table; found \[\]; fix it$"):
            fitted([], Outer, "file", "fix it")


class TestMessages:
    @pytest.mark.parametrize(
        "value",
        [MEGABYTES, [MEGABYTES] * 1000, {MEGABYTES: [[[[[[[1]]]]]]]}, 10**10_000, b"x" * 9999],
        ids=["text", "list", "table", "number", "bytes"],
    )
    def test_short_values_are_short(self, value):
        assert len(short(value)) < 100

    def test_short_values_are_kept_whole(self):
        assert [short(value) for value in ("a", 3, None, [1, "b"], {"a": 1.5})] == [
            "'a'", "3", "None", "[1, 'b']", "{'a': 1.5}",
        ]  # fmt: skip

    def test_cut_keeps_the_file_and_the_fix(self):
        message = cut(f"file.csv: found {MEGABYTES}; fix it")
        assert len(message) == MAX_MESSAGE
        assert message.startswith("file.csv: found xxx")
        assert message.endswith("xxx; fix it")
