"""Topics and messages as the scanners find them, and the compressions of MCAP and of whole files."""

from dataclasses import dataclass
from typing import Any, Final

from quadruped_env.errors import MissingExtraError

ZSTD_MAGIC: Final = b"\x28\xb5\x2f\xfd"
MAX_SIZE: Final = 1 << 30
"""Maximum bytes of a chunk: no recorder writes larger ones, and damaged bytes may claim any size."""

_STEP: Final = 4096


@dataclass(frozen=True)
class Topic:
    """A topic in a bag."""

    key: Any
    """Its number in the bag, by which messages refer to it"""
    name: str
    message_type: str
    encoding: str = ""
    """Serialization of its messages, where it is known"""


@dataclass(frozen=True)
class Message:
    """A message, as recorded."""

    topic: Any
    """Key of its topic"""
    time: int
    """Time of recording, ns"""
    data: bytes
    message_type: str = ""
    """One of `RECORDED_TYPES`, once it is known"""
    checked: bool = False
    """True if a checksum covers the bytes and is correct"""


def zstd() -> Any:
    """Return the module for zstd, which rosbags installs.

    Raises:
        MissingExtraError: if it is not installed.
    """
    try:
        from rosbags.rosbag2 import reader
    except ImportError as error:
        raise MissingExtraError("reading compressed bags", "ros") from error
    return reader.zstd


def zstd_has_checksum(data: bytes) -> bool:
    """Return True if a zstd frame has a content checksum, according to its header (RFC 8878, section 3.1.1.1.1)."""
    return data.startswith(ZSTD_MAGIC) and len(data) > 4 and bool(data[4] & 0x04)


def decompress(data: bytes, compression: str, size: int) -> tuple[bytes, bool]:
    """Return the readable part of compressed data.

    Returns:
        The data, up to damage, and whether the compression's own checksum is correct.

    Raises:
        ValueError: if nothing can be read.
    """
    if size > MAX_SIZE:
        raise ValueError(f"it claims {size} bytes")
    if not compression:
        return data[:size], False
    decompressor: Any
    if compression == "zstd":
        decompressor, has_checksum = zstd().ZstdDecompressor(), zstd_has_checksum(data)
    elif compression == "lz4":
        from lz4.frame import LZ4FrameDecompressor

        # https://github.com/lz4/lz4/blob/dev/doc/lz4_Frame_format.md: the flag C.Checksum
        decompressor, has_checksum = LZ4FrameDecompressor(), len(data) > 4 and bool(data[4] & 0x04)
    else:
        raise ValueError(f"unknown compression {compression!r}")
    plain = bytearray()
    # In small steps: a call that fails returns nothing.
    for start in range(0, len(data), _STEP):
        if decompressor.eof or len(plain) > size:
            break
        try:
            plain += decompressor.decompress(data[start : start + _STEP])
        # Each library raises errors of its own type.
        except Exception:
            break
    # The libraries check the checksum at the end.
    return bytes(plain), has_checksum and bool(decompressor.eof)
