"""The same numbers on the same kind of processor, and which of them another kind changes."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
import rollouts
from safetensors.numpy import load_file

HASHES = Path(__file__).with_name("rollout_hashes.json")
REFERENCE = Path(__file__).with_name("rollout.safetensors")
"""Results on the first platform of the hashes."""


def test_rollout_of_the_shipped_policy_has_the_hashes_of_this_platform():
    known, key = json.loads(HASHES.read_text()), rollouts.platform_key()
    found = rollouts.rollout("flat")
    difference = rollouts.first_difference(found, load_file(REFERENCE))
    if key not in known:
        line = f"{json.dumps(key)}: {json.dumps(rollouts.hashes(found))}"
        pytest.skip(f"unknown platform, first difference from the reference: {difference or 'none'}; add {line}")
    assert rollouts.hashes(found) == known[key], f"first difference from the reference: {difference}"


def test_first_difference_names_step_quantity_and_size():
    expected = load_file(REFERENCE)
    found = {name: expected[name].copy() for name in ("rewards", "observations")}
    assert rollouts.first_difference(found, expected) == ""
    found["observations"][7, 3] += 1.0
    found["rewards"][7] += 1e-9
    assert rollouts.first_difference(found, expected) == "rewards at step 7, by up to 1.0e-09"


@pytest.mark.slow
def test_env_gives_the_same_numbers_with_every_kernel_of_the_blas():
    results = []
    for kernel in ("Haswell", ""):
        environment = os.environ | {"OPENBLAS_CORETYPE": kernel}
        run = subprocess.run([sys.executable, rollouts.__file__], env=environment, capture_output=True, check=True)
        results.append(json.loads(run.stdout))
    if results[0]["kernel"] == results[1]["kernel"]:
        pytest.skip(f"NumPy's BLAS has the kernel {results[0]['kernel']} only")
    assert results[0]["hashes"] == results[1]["hashes"]
