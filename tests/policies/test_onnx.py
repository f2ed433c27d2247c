"""Policies of ONNX files: graphs of operators as rsl_rl, mjlab and other trainers write them."""

import json

import numpy as np
import pytest
from policies import observations

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env.cli.main import main
from quadruped_env.policies import Policy, load_policy

onnx = pytest.importorskip("onnx", reason="onnx is not installed: pip install -e '.[export]'")
helper = onnx.helper

RANDOM = np.random.default_rng(0)
ARRAYS = {
    "w0": RANDOM.normal(0.0, 0.1, (16, 102)),
    "b0": RANDOM.normal(0.0, 0.1, 16),
    "w1": RANDOM.normal(0.0, 0.3, (16, 8)),
    "b1": RANDOM.normal(0.0, 0.1, 8),
    "mean": RANDOM.normal(0.0, 0.5, (1, 102)),
    "deviation": RANDOM.uniform(0.5, 2.0, (1, 102)),
    "two": np.array(2.0),
    "one": np.array(1.0),
    "minus_one": np.array(-1.0),
}
NORMALIZED = ["Sub x mean", "Div . deviation"]
"""As rsl_rl's EmpiricalNormalization."""
FIRST = ["Gemm . w0 b0 transB=1"]
LAST = ["MatMul . w1", "Add . b1"]


def write(path, nodes, inputs=("x",), width=102):
    """A file with nodes 'Operator INPUT... NAME=VALUE...'; `.` is the value of the node before, `..` of that before."""
    values, made = ["x"], []
    for node in nodes:
        kind, *words = node.split()
        attributes = {name: float(value) for name, value in (word.split("=") for word in words if "=" in word)}
        attributes = {name: int(value) if name.startswith("trans") else value for name, value in attributes.items()}
        read = [{".": values[-1], "..": values[-2] if len(values) > 1 else ""}.get(w, w) for w in words if "=" not in w]
        values.append(f"v{len(values)}")
        made.append(helper.make_node(kind, read, [values[-1]], **attributes))
    graph = helper.make_graph(
        made,
        "policy",
        [helper.make_tensor_value_info(name, 1, [1, width]) for name in inputs],
        [helper.make_tensor_value_info(values[-1], 1, [1, 8])],
        [onnx.numpy_helper.from_array(array.astype(np.float32), name) for name, array in ARRAYS.items()],
    )
    onnx.save(helper.make_model(graph, opset_imports=[helper.make_opsetid("", 22)], ir_version=10), path)
    return path


def by_hand(x, activate, normalized=False, gain=1.0):
    if normalized:
        x = (x - ARRAYS["mean"]) / ARRAYS["deviation"]
    return gain * (activate(x @ ARRAYS["w0"].T + ARRAYS["b0"]) @ ARRAYS["w1"] + ARRAYS["b1"])


def relu(x):
    return np.maximum(x, 0.0)


def elu(x):
    return np.where(x > 0.0, x, np.expm1(np.minimum(x, 0.0)))


@pytest.mark.parametrize(
    ("nodes", "expected"),
    [
        ([*FIRST, "Elu .", *LAST], lambda x: by_hand(x, elu)),
        ([*NORMALIZED, *FIRST, "Elu .", *LAST], lambda x: by_hand(x, elu, normalized=True)),
        ([*FIRST, "Sigmoid .", "Mul . ..", *LAST], lambda x: by_hand(x, lambda h: h / (1.0 + np.exp(-h)))),
        ([*FIRST, "Tanh .", *LAST, "Tanh ."], lambda x: np.tanh(by_hand(x, np.tanh))),
        ([*FIRST, "Relu .", *LAST, "Clip . minus_one one"], lambda x: by_hand(x, relu)),
        (
            [*FIRST, "Relu .", "Identity .", *LAST, "Mul . two"],
            lambda x: by_hand(x, relu, gain=2.0),
        ),
        ([*FIRST, "Elu .", "Mul . two", "Sub one .", *LAST], lambda x: by_hand(x, lambda h: 1.0 - 2.0 * elu(h))),
    ],
)
def test_graph_becomes_a_policy_with_its_actions(nodes, expected, tmp_path):
    Policy.from_onnx(write(tmp_path / "policy.onnx", nodes)).save(tmp_path / "run")
    policy, seen = load_policy(tmp_path / "run"), observations((20,))
    np.testing.assert_allclose(policy.predict(seen), np.clip(expected(seen.astype(np.float64)), -1.0, 1.0), atol=1e-5)
    assert np.abs(policy.predict(seen)).max() > 0.1
    assert len(policy.weights) == 2
    assert policy.card["imported_from"]["name"] == "policy.onnx"


@pytest.mark.parametrize(
    ("nodes", "message"),
    [
        ([*FIRST, "LSTM . w0 w1", *LAST], r"it has the operator LSTM here; a policy can be a chain of linear layers"),
        ([*FIRST, "Elu .", *LAST, "Elu ."], r"does not end with a linear layer"),
        ([*FIRST, "Elu .", *LAST, "Tanh .", "Mul . two"], r"does not end with a linear layer"),
        ([*FIRST, "Elu .", "Gemm . w1 transA=1"], r"the operator Gemm here"),
        ([*FIRST, "Tanh .", "Elu .", *LAST], r"the operator Elu here"),
        ([*FIRST, "Add . ..", "Elu .", *LAST], r"its operator Add does not read the value before it alone"),
        ([*FIRST, "Elu .", *LAST, "Clip . minus_one two"], r"the operator Clip here"),
        ([*FIRST, "Elu .", *LAST, "Clip . minus_one one", "Mul . two"], r"the operator Mul after its Clip"),
        ([*FIRST, "Elu . alpha=0.5", *LAST], r"the graph computes its action in a way of its own"),
        ([*FIRST, "Elu ."], r"does not end with a linear layer"),
    ],
)
def test_other_graph_is_refused_with_the_operator(nodes, message, tmp_path):
    with pytest.raises(QuadrupedError, match=rf"policy.onnx: .*({message})"):
        Policy.from_onnx(write(tmp_path / "policy.onnx", nodes))


def test_graph_of_two_inputs_and_file_that_is_no_graph_are_refused(tmp_path):
    with pytest.raises(QuadrupedError, match=r"the graph has 2 inputs and 1 outputs, not one of each"):
        Policy.from_onnx(write(tmp_path / "policy.onnx", [*FIRST, "Elu .", *LAST], inputs=("x", "state")))
    (tmp_path / "policy.onnx").write_bytes(b"\x08\x07")
    with pytest.raises(QuadrupedError, match=r"policy.onnx: cannot be read as ONNX .*export it again"):
        Policy.from_onnx(tmp_path / "policy.onnx")
    with pytest.raises(QuadrupedError, match=r"nothing.onnx: there is no such file"):
        Policy.from_onnx(tmp_path / "nothing.onnx")


def test_weights_that_are_not_finite_are_not_saved(tmp_path, monkeypatch):
    monkeypatch.setitem(ARRAYS, "b1", np.full(8, np.nan))
    with pytest.raises(QuadrupedError, match=r"layer1 holds NaN or infinity"):
        Policy.from_onnx(write(tmp_path / "policy.onnx", [*FIRST, "Elu .", *LAST])).save(tmp_path / "run")


def test_program_imports_a_file_of_the_task_that_is_given(tmp_path, capsys):
    path = str(write(tmp_path / "walk.onnx", [*FIRST, "Elu .", *LAST]))
    task = {"action": {"position_scale": 0.5}, "observation_history": 2}
    command = ["import-policy", path, "-o", str(tmp_path / "run"), "--task"]
    assert main([*command, json.dumps(task)]) == 2
    assert "its observations have the shape (102,), and this task's have (68,): 2 x (proj" in capsys.readouterr().err
    assert main([*command, json.dumps(task | {"observation_history": 3})]) == 0
    assert "2 layers, elu -> " in (printed := capsys.readouterr().out)
    assert "assumed: action mode position (--action-mode), actions of 0.5 rad, without VecNormalize" in printed
    assert "unpickling" not in printed
    assert load_policy(tmp_path / "run").control.action.scale == 0.5
    assert main([*command[:-1], "--overwrite", "--vecnormalize", "statistics.pkl"]) == 2
    assert "--vecnormalize: found with an ONNX file" in capsys.readouterr().err


def test_without_onnx_the_extra_is_named(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "onnx", None)
    with pytest.raises(MissingExtraError, match=r"needs the 'export' extra"):
        Policy.from_onnx("walk.onnx")
