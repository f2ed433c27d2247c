"""Policies on the Hugging Face Hub, as `mini-quadruped export --hub` writes them: `hf://OWNER/NAME[@REVISION]`.

Only the policy's two files are downloaded, JSON and safetensors, into the cache of the hub's own client. No code is.
"""

import warnings
from pathlib import Path
from typing import Final

from quadruped_env.errors import MissingExtraError, QuadrupedError, QuadrupedWarning, short
from quadruped_env.policies.policy_data import CARD_FILE, TENSORS_FILE

SCHEME: Final = "hf://"
TIMEOUT: Final = 10.0
"""Timeout for an answer of the hub, s."""


def is_on_hub(source: object) -> bool:
    """Return True for the address of a policy on the hub."""
    return str(source).startswith(SCHEME)


def hub_directory(address: str) -> Path:
    """Return the directory of the cache with the two files of a policy, which are downloaded if the hub has newer ones.

    Raises:
        MissingExtraError: if the hub's client is not installed.
        QuadrupedError: if the address has another form, the repository, its revision or one of the files does not
            exist, or the hub cannot be reached and the cache does not have them.

    Warns:
        QuadrupedWarning: if the hub cannot be reached, so that the files of the cache are used.
    """
    try:
        from huggingface_hub import errors, get_hf_file_metadata, hf_hub_download, hf_hub_url
    except ImportError as error:
        raise MissingExtraError(f"{short(address)}", "hub") from error
    repository, _, revision = address.removeprefix(SCHEME).partition("@")
    if repository.count("/") != 1:
        raise QuadrupedError(f"{short(address)}: expected hf://OWNER/NAME or hf://OWNER/NAME@REVISION")
    named = (errors.EntryNotFoundError, errors.RepositoryNotFoundError, errors.RevisionNotFoundError)
    unreachable = ""
    try:
        url = hf_hub_url(repository, CARD_FILE, revision=revision or None)
        try:  # once, where the client would try for minutes
            if get_hf_file_metadata(url, timeout=TIMEOUT).commit_hash is None:
                unreachable = "the answer does not come from a hub"
        except named:
            raise
        except errors.OfflineModeIsEnabled:
            unreachable = "the client is offline"
        except Exception as error:  # of the client's HTTP library, which is another one in each of its versions
            unreachable = _first_line(error)
        card, _ = (
            hf_hub_download(repository, name, revision=revision or None, local_files_only=bool(unreachable))
            for name in (CARD_FILE, TENSORS_FILE)
        )
    except Exception as error:  # of the client or, as above, of its HTTP library
        problems: dict[type[Exception], str] = {  # a class comes before its base
            errors.LocalEntryNotFoundError: f"the hub cannot be reached ({unreachable}), and its policy is not in the "
            f"cache; connect, or name a directory",
            errors.RevisionNotFoundError: f"the repository has no revision {short(revision)}; leave it out",
            errors.RepositoryNotFoundError: "there is no such repository, or it is private or gated; check its name, "
            "or run 'hf auth login'",
            errors.EntryNotFoundError: f"has no {CARD_FILE} with {TENSORS_FILE}, so it is not a policy of this "
            f"package; upload one with 'mini-quadruped export --hub'",
            Exception: f"cannot be downloaded ({_first_line(error)}); check the name, and try again",
        }
        problem = next(text for kind, text in problems.items() if isinstance(error, kind))
        raise QuadrupedError(f"{address}: {problem}") from error
    if unreachable:
        problem = f"the hub cannot be reached ({unreachable}); its policy in the cache is used"
        warnings.warn(f"{address}: {problem}", QuadrupedWarning, stacklevel=2)
    return Path(card).parent


def _first_line(error: Exception) -> str:
    return (str(error) or type(error).__name__).partition("\n")[0]
