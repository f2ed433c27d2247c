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
    checked: bool = False
    """Whether a checksum says that these are the bytes that were recorded"""


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


def zstd_has_checksum(data: bytes) -> bool:
    """Whether a zstd frame that begins so ends with a checksum of its content (RFC 8878, section 3.1.1.1.1)."""
    return data.startswith(ZSTD_MAGIC) and len(data) > 4 and bool(data[4] & 0x04)


def decompress(data: bytes, compression: str, size: int) -> tuple[bytes, bool]:
    """As much as can be read of compressed data, and whether a checksum within it holds; ValueError if nothing can."""
    if size > MAX_SIZE:
        raise ValueError(f"it claims {size} bytes")
    if not compression:
        return data[:size], False
    decompressor: Any
    if compression == "zstd":
        decompressor, has_checksum = zstd().ZstdDecompressor(), zstd_has_checksum(data)
    elif compression == "bz2":
        decompressor, has_checksum = bz2.BZ2Decompressor(), True
    elif compression == "lz4":
        from lz4.frame import LZ4FrameDecompressor

        # https://github.com/lz4/lz4/blob/dev/doc/lz4_Frame_format.md: the flag C.Checksum
        decompressor, has_checksum = LZ4FrameDecompressor(), len(data) > 4 and bool(data[4] & 0x04)
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
    # Whether the checksum holds, the libraries see at the end.
    return bytes(plain), has_checksum and bool(decompressor.eof)
