"""Policies on the Hugging Face Hub, as `mini-quadruped export --hub` writes them: `hf://OWNER/NAME[@REVISION]`.

Only the policy's two files are downloaded, JSON and safetensors, into the cache of the hub's own client. No code is.
"""

from pathlib import Path
from typing import Final

from quadruped_env.control.policy import CARD_FILE, TENSORS_FILE
from quadruped_env.errors import MissingExtraError, QuadrupedError, short

SCHEME: Final = "hf://"


def is_on_hub(source: object) -> bool:
    """True for the address of a policy on the hub."""
    return str(source).startswith(SCHEME)


def hub_directory(address: str) -> Path:
    """Directory of the cache with the two files of a policy, which are downloaded if the hub has newer ones.

    Raises:
        MissingExtraError: if the hub's client is not installed.
        QuadrupedError: if the address has another form, the repository, its revision or one of the files does not
            exist, or the hub cannot be reached and the cache does not have them.
    """
    try:
        import huggingface_hub
        from huggingface_hub import errors
    except ImportError as error:
        raise MissingExtraError(f"{short(address)}", "hub") from error
    repository, _, revision = address.removeprefix(SCHEME).partition("@")
    if repository.count("/") != 1:
        raise QuadrupedError(f"{short(address)}: expected hf://OWNER/NAME or hf://OWNER/NAME@REVISION")
    try:
        card, _ = (
            Path(huggingface_hub.hf_hub_download(repository, name, revision=revision or None))
            for name in (CARD_FILE, TENSORS_FILE)
        )
    except (errors.LocalEntryNotFoundError, errors.OfflineModeIsEnabled) as error:
        problem = "the hub cannot be reached, and its policy is not in the cache; connect, or name a directory"
        raise QuadrupedError(f"{address}: {problem}") from error
    except errors.RevisionNotFoundError as error:
        raise QuadrupedError(f"{address}: the repository has no revision {short(revision)}; leave it out") from error
    except errors.RepositoryNotFoundError as error:
        problem = "there is no such repository, or it is private or gated; check its name, or run 'hf auth login'"
        raise QuadrupedError(f"{address}: {problem}") from error
    except errors.EntryNotFoundError as error:
        problem = f"has no {CARD_FILE} with {TENSORS_FILE}, so it is not a policy of this package"
        raise QuadrupedError(f"{address}: {problem}; upload one with 'mini-quadruped export --hub'") from error
    except (OSError, ValueError) as error:  # also the client's own errors of HTTP, and of names that it refuses
        raise QuadrupedError(f"{address}: cannot be downloaded ({error}); check the name, and try again") from error
    return card.parent
