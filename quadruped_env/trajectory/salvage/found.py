"""What the scanners of all formats find, and the compressions that they share."""

import bz2
from dataclasses import dataclass
from typing import Any, Final

from quadruped_env.errors import MissingExtraError

ZSTD_MAGIC: Final = b"\x28\xb5\x2f\xfd"
MAX_SIZE: Final = 1 << 30
"""Bytes: no recorder writes a larger chunk, and damage may claim any size"""

_STEP: Final = 4096


@dataclass(frozen=True)
class Topic:
    """A topic that a bag has."""

    key: Any
    """What its messages call it"""
    name: str
    message_type: str


@dataclass(frozen=True)
class Message:
    """A message as it was recorded."""

    topic: Any
    """Key of its topic"""
    time: int
    """ns of recording"""
    data: bytes


def zstd() -> Any:
    """The module that reads zstd, which rosbags brings.

    Raises:
        MissingExtraError: if it is not installed.
    """
    try:
        from rosbags.rosbag2 import reader
    except ImportError as error:
        raise MissingExtraError("reading compressed bags", "ros") from error
    return reader.zstd


def decompress(data: bytes, compression: str, size: int) -> bytes:
    """As much as can be read of compressed data; ValueError if nothing can."""
    if size > MAX_SIZE:
        raise ValueError(f"it claims {size} bytes")
    if not compression:
        return data[:size]
    decompressor: Any
    if compression == "zstd":
        decompressor = zstd().ZstdDecompressor()
    elif compression == "bz2":
        decompressor = bz2.BZ2Decompressor()
    elif compression == "lz4":
        from lz4.frame import LZ4FrameDecompressor

        decompressor = LZ4FrameDecompressor()
    else:
        raise ValueError(f"unknown compression {compression!r}")
    plain = bytearray()
    # In small steps: one that fails gives nothing back.
    for start in range(0, len(data), _STEP):
        if decompressor.eof or len(plain) > size:
            break
        try:
            plain += decompressor.decompress(data[start : start + _STEP])
        # The libraries' own types of error, whichever it is.
        except Exception:
            break
    return bytes(plain)
