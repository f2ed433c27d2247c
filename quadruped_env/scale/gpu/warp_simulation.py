"""Simulation of thousands of robots on a GPU, on MuJoCo Warp.

Its arrays are torch tensors on the device, and physics is float32. Between control steps nothing is copied to the host
but a few flags. The kernels also run on the CPU (device `cpu`), world by world, for tests.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, Final

import mujoco
import numpy as np

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.robot.motors import fill_command_history
from quadruped_env.robot.readings import Readings, sensor_columns
from quadruped_env.robot.robot import Robot
from quadruped_env.simulation.height_field import GROUND
from quadruped_env.simulation.simulation_interface import STATE_SPEC, SimulationState

try:
    import torch
    import warp

    # Otherwise it prints its devices, and each kernel that it compiles; `check_device` says what is wrong with a GPU.
    warp.config.log_level = warp.LOG_ERROR
    import mujoco_warp

    from quadruped_env.scale.gpu.torch_arrays import TensorArray
    from quadruped_env.scale.gpu.warp_kernels import restart_diverged
except ImportError as error:  # pragma: no cover
    raise MissingExtraError("physics on a GPU", "gpu") from error

ITERATIONS: Final = 20
"""Maximum number of solver iterations. In float32 the solver converges more slowly than MuJoCo's in float64."""
LINE_SEARCH_ITERATIONS: Final = 50
CONTACTS: Final = 24
"""Contacts per world for which memory is reserved; the worlds share it."""
CONSTRAINTS: Final = 120
"""Scalar constraints per world for which memory is reserved."""

_OLDEST_DRIVER: Final = (12, 4)
"""Oldest CUDA version of a driver with conditional nodes in graphs, which the solver's loop needs."""
_INERTIA_FIELDS: Final = frozenset({"body_mass", "body_inertia", "body_ipos", "body_iquat", "dof_armature"})
"""Fields on which constants of the model depend."""
_CONSTANTS: Final = ("body_subtreemass", "body_invweight0", "dof_invweight0")
"""These constants."""
_OVERFLOWS: Final = {
    mujoco_warp.OverflowType.NEFC: ("constraints per world", "constraints"),
    mujoco_warp.OverflowType.BROADPHASE: ("contacts per world", "contacts"),
    mujoco_warp.OverflowType.NARROWPHASE: ("contacts per world", "contacts"),
    mujoco_warp.OverflowType.CCD: ("contacts per world", "contacts"),
}
"""Kinds of overflow that lose contacts or constraints: what ran out, and the argument that reserves more."""


class WarpSimulation:
    """`Simulation` with many envs on a GPU. All its arrays are `TensorArray`.

    Args:
        model: model of the robot on level ground.
        num_envs: number of envs, N; a world of MuJoCo Warp each.
        robot: robot that the model describes.
        device: Warp's name of the device: `cuda`, `cuda:1` or, for tests, `cpu`.
        contacts: contacts per world for which memory is reserved.
        constraints: scalar constraints per world for which memory is reserved.

    Raises:
        QuadrupedError: if the device is not usable, or the model's ground is not level.
    """

    height_field = None

    def __init__(
        self,
        model: mujoco.MjModel,
        num_envs: int,
        robot: Robot,
        device: str = "cuda",
        contacts: int = CONTACTS,
        constraints: int = CONSTRAINTS,
    ) -> None:
        self._device = check_device(device)
        if (model.geom_type == mujoco.mjtGeom.mjGEOM_HFIELD).any():
            raise QuadrupedError(
                f"terrain: the geom {GROUND!r} is a height field, with which MuJoCo Warp collides in another way than "
                f"MuJoCo; train on level ground, or with --device cpu"
            )
        self.model, self.robot, self.num_envs = pinned(model), robot, num_envs
        self._reserved = {"contacts": contacts, "constraints": constraints}
        self.torch_device = torch.device(warp.device_to_torch(self._device))
        with warp.ScopedDevice(self._device):
            self.warp_model = mujoco_warp.put_model(self.model)
            self.warp_model.opt.warn_overflow = 0  # `step` raises an error
            self.data = mujoco_warp.make_data(self.model, num_envs, nconmax=contacts, njmax=constraints)
            self._initial_qpos = warp.array(self.model.qpos0, dtype=float)
            self._failed = warp.zeros(num_envs, dtype=bool)
        data = self.data
        shape = num_envs, self.model.nsensordata
        self.sensordata = TensorArray(torch.zeros(shape, dtype=torch.float64, device=self.torch_device))
        """Copy of the sensor data with the precision of the task."""
        sensordata: Any = self.sensordata
        self.readings = Readings.from_sensordata(self.model, sensordata, robot)
        self.sensor_columns = sensor_columns(self.model, robot)
        self._measured = _view(data.sensordata)
        self._qpos, self._qvel, self._ctrl = _view(data.qpos), _view(data.qvel), _view(data.ctrl)
        self._warmstart, self._time = _view(data.qacc_warmstart), _view(data.time)
        self._history = _view(data.history) if self.model.nhistory else None
        self._external = _view(data.xfrc_applied)
        self._diverged = _view(self._failed)
        self._overflow = _view(data.overflow)
        self._base = self.model.body(robot.base_name).id
        self._fields: dict[str, TensorArray] = {}
        self._graphs: dict[Any, Any] = {}
        self._initial_history = self._filled_history()
        self._record(1)
        self._settle()

    def step(self, joint_target: TensorArray, substeps: int, env_ids: TensorArray | None = None) -> None:
        """See `Simulation.step`; all envs advance together.

        Raises:
            QuadrupedError: if a world has more contacts or constraints than memory was reserved for, or only some envs
                are to be advanced.
        """
        if env_ids is not None:
            raise QuadrupedError("step: on a GPU all envs advance together; reset those whose episode has ended")
        self._ctrl.copy_(joint_target.tensor)
        if substeps != len(self._recorded):
            self._record(substeps)
        self._launch(("step", substeps), lambda: self._advance(substeps))
        self._check_overflow()
        self.sensordata.tensor.copy_(self._measured)
        self._past.tensor.copy_(_view(self._recorded))

    def _record(self, substeps: int) -> None:
        """Make room for the readings of a number of physics steps."""
        shape = substeps, self.num_envs, self.model.nsensordata
        with warp.ScopedDevice(self._device):
            self._recorded = warp.zeros(shape, dtype=float)
        self._past = TensorArray(torch.zeros(shape, dtype=torch.float64, device=self.torch_device))
        past: Any = self._past
        self.substeps = Readings.from_sensordata(self.model, past, self.robot)
        self._graphs.clear()  # they write to the array before

    def _advance(self, substeps: int) -> None:
        """Physics steps, and the first half of another, as in the other drivers."""
        model, data = self.warp_model, self.data
        for substep in range(substeps):
            mujoco_warp.step1(model, data)
            mujoco_warp.step2(model, data)
            warp.copy(self._recorded[substep], data.sensordata)
        warp.launch(
            restart_diverged,
            dim=self.num_envs,
            inputs=[self._initial_qpos, data.qacc],
            outputs=[data.qpos, data.qvel, data.qacc_warmstart, self._failed],
        )
        self._first_half()

    def _first_half(self) -> None:
        """`mujoco_warp.step1` without clearing the forces, which are those of the last physics step."""
        model, data = self.warp_model, self.data
        mujoco_warp.fwd_position(model, data)
        mujoco_warp.sensor_pos(model, data)
        mujoco_warp.fwd_velocity(model, data)
        mujoco_warp.sensor_vel(model, data)

    def _settle(self) -> None:
        self._launch("settle", self._first_half)

    def _launch(self, name: Any, function: Callable[[], None]) -> None:
        """Call a function that launches kernels; on a GPU it is called once, then its kernels repeat as a graph."""
        with self._kernels():
            if not self._device.is_cuda:
                function()
            elif name not in self._graphs:
                function()  # compiles the kernels
                with warp.ScopedCapture() as capture:
                    function()
                # Capturing launches nothing, so the state has advanced once.
                self._graphs[name] = capture.graph
            else:
                warp.capture_launch(self._graphs[name])

    @contextmanager
    def _kernels(self) -> Iterator[None]:
        """Within it Warp's kernels run on the device, after what torch has launched and before what it will launch."""
        with warp.ScopedDevice(self._device):
            if not self._device.is_cuda:
                yield
                return
            own, others = warp.get_stream(self._device), warp.stream_from_torch(self.torch_device)
            own.wait_stream(others)
            yield
            others.wait_stream(own)

    def _check_overflow(self) -> None:
        found = self._overflow
        if not found.any():
            return
        bits = int(np.bitwise_or.reduce(found.cpu().numpy()))
        for kind, (what, argument) in _OVERFLOWS.items():
            if bits & kind:
                reserved = self._reserved[argument]
                raise QuadrupedError(
                    f"step: a world has more than {reserved} {what}, for which memory is reserved; results would be "
                    f"wrong. Reserve more: WarpSimulation({argument}={2 * reserved})"
                )
        found.zero_()  # the solver's iterations ran out, which is no error in MuJoCo either

    def reset(self, env_ids: TensorArray, qpos: TensorArray, qvel: TensorArray) -> None:
        """See `Simulation.reset`."""
        if not len(env_ids):
            return
        index, start = env_ids.tensor, qpos.tensor.to(torch.float32)
        self._qpos[index], self._qvel[index] = start, qvel.tensor.to(torch.float32)
        self._ctrl[index] = start[:, 7:]
        self._warmstart[index], self._time[index], self._external[index] = 0.0, 0.0, 0.0
        self._diverged[index] = False
        if self._history is not None:
            self._history[index] = self._initial_history
            for joint, columns in self._command_columns.items():
                self._history[index[:, None], columns] = start[:, 7 + joint, None]
        self._forward()
        self.sensordata.tensor[index] = self._measured[index].double()

    def _forward(self) -> None:
        """Recompute what follows from the state and the fields of the model, in all envs."""
        if _INERTIA_FIELDS & set(self._fields):
            with self._kernels():
                mujoco_warp.set_const(self.warp_model, self.data, _GROUPS)
        self._launch("forward", lambda: mujoco_warp.forward(self.warp_model, self.data))

    def _filled_history(self) -> torch.Tensor:
        """Buffers of delayed motors at the start (nhistory,), and the columns of each motor's commands."""
        initial = mujoco.MjData(self.model).history.copy()
        marked = np.zeros((1, self.model.nhistory))
        self._command_columns: dict[int, torch.Tensor] = {}
        for joint in range(self.robot.num_joints if self.model.nhistory else 0):
            target = np.zeros((1, self.robot.num_joints))
            target[0, joint] = 1.0
            marked[:] = 0.0
            fill_command_history(self.model, marked, target)
            self._command_columns[joint] = torch.as_tensor(np.flatnonzero(marked[0])).to(self._measured.device)
        return torch.as_tensor(initial, dtype=torch.float32, device=self._measured.device)

    def diverged(self) -> TensorArray:
        """See `Simulation.diverged`."""
        return TensorArray(self._diverged.clone())

    def push(self, env_ids: TensorArray, velocity: TensorArray) -> None:
        """See `Simulation.push`."""
        index = env_ids.tensor
        self._qvel[index, : velocity.shape[1]] += velocity.tensor.float()
        self._settle()

    def set_force(self, env_ids: TensorArray, force: TensorArray) -> None:
        """See `Simulation.set_force`."""
        self._external[env_ids.tensor, self._base, :3] = force.tensor.float()

    def model_field(self, name: str) -> TensorArray:
        """See `Simulation.model_field`. The values are float32.

        Raises:
            QuadrupedError: if MuJoCo Warp has one value of the field for all envs.
        """
        if name not in self._fields:
            self._expand([name, *(_CONSTANTS if name in _INERTIA_FIELDS else ())])
        return self._fields[name]

    def _expand(self, names: list[str]) -> None:
        """Give each env its own values of fields of the model."""
        new = [name for name in names if name not in self._fields]
        missing = [name for name in new if not hasattr(self.warp_model, name)]
        try:
            with warp.ScopedDevice(self._device):
                batched = mujoco_warp.put_model(self.model, dict.fromkeys(new, self.num_envs))
        except ValueError as error:
            raise QuadrupedError(
                f"randomization: on a GPU the model's field {(missing or new)[0]!r} is the same in all envs ({error}); "
                f"set the randomization to null, or train with --device cpu"
            ) from error
        for name in new:
            setattr(self.warp_model, name, getattr(batched, name))
            self._fields[name] = TensorArray(_view(getattr(batched, name)))
        self._graphs.clear()  # they refer to the arrays before

    def _array(self, values: Any) -> TensorArray:
        array: Any = np.asarray(values, like=self.sensordata)
        return array

    def compiled_field(self, name: str) -> np.ndarray:
        """See `Simulation.compiled_field`."""
        return getattr(self.model, name)

    def field_values(self, name: str) -> TensorArray:
        """See `Simulation.field_values`."""
        return self._fields[name] if name in self._fields else self._array(getattr(self.model, name)[None])

    def restore_model_fields(self, env_ids: TensorArray) -> None:
        """See `Simulation.restore_model_fields`."""
        for name, values in self._fields.items():
            values[env_ids] = getattr(self.model, name)

    def get_state(self, env_id: int) -> SimulationState:
        """See `Simulation.get_state`."""
        shape = self.num_envs, mujoco.mj_stateSize(self.model, STATE_SPEC)
        state = warp.zeros(shape, dtype=float, device=self._device)
        with self._kernels():
            mujoco_warp.get_state(self.warp_model, self.data, state, int(STATE_SPEC))
        fields = {name: values[env_id].numpy() for name, values in sorted(self._fields.items())}
        return SimulationState(
            _view(state)[env_id].cpu().numpy().astype(np.float64),
            self.sensordata[env_id].numpy(),
            bool(self._diverged[env_id]),
            fields,
        )

    def set_state(self, env_id: int, state: SimulationState) -> None:
        """See `Simulation.set_state`; a state of another driver is rounded to float32."""
        self.set_states(self._array([env_id]), [state])

    def set_states(self, env_ids: TensorArray, states: list[SimulationState]) -> None:
        """Restore states (R,) in some envs (R,), as `set_state` does in one."""
        index = env_ids.tensor
        device = self._measured.device
        for name in states[0].model_fields:
            self.model_field(name)[env_ids] = np.stack([state.model_fields[name] for state in states])
        integration = torch.zeros((self.num_envs, len(states[0].integration)), device=device)
        integration[index] = torch.tensor(np.stack([state.integration for state in states]), device=device).float()
        active = torch.zeros(self.num_envs, dtype=torch.bool, device=device)
        active[index] = True
        with self._kernels():
            if _INERTIA_FIELDS & set(self._fields):
                mujoco_warp.set_const(self.warp_model, self.data, _GROUPS)
            mujoco_warp.set_state(
                self.warp_model, self.data, warp.from_torch(integration), int(STATE_SPEC), warp.from_torch(active)
            )
        self._settle()
        self.sensordata[env_ids] = np.stack([state.readings for state in states])
        self._diverged[index] = torch.tensor([state.diverged for state in states], device=device)


_GROUPS: Final = int(mujoco_warp.SetConstGroup.FIXED | mujoco_warp.SetConstGroup.INERT0)


def pinned(model: mujoco.MjModel) -> mujoco.MjModel:
    """Copy of a model with the integrator, the solver and its limits with which it was compared with MuJoCo's results.

    The friction cone stays the model's.
    """
    result = mujoco.MjModel.__copy__(model)
    result.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    result.opt.solver = mujoco.mjtSolver.mjSOL_NEWTON
    result.opt.iterations, result.opt.ls_iterations = ITERATIONS, LINE_SEARCH_ITERATIONS
    # Which pairs of geoms are compared first has no effect on the contacts.
    result.opt.disableflags &= ~int(mujoco.mjtDisableBit.mjDSBL_MIDPHASE)
    return result


def check_device(name: str) -> Any:
    """Warp's device of a name.

    Raises:
        QuadrupedError: if it does not exist, torch does not support it, or its driver is too old; the message names
            what to check.
    """
    warp.init()
    if name.partition(":")[0] not in ("cpu", "cuda"):
        raise QuadrupedError(f"--device: {name!r} is unknown; expected cuda, or cuda:N for GPU N")
    if name.startswith("cuda"):
        driver = warp.get_cuda_driver_version()
        if driver is not None and tuple(driver) < _OLDEST_DRIVER:
            raise QuadrupedError(
                f"--device: {name}: the GPU's driver is for CUDA {'.'.join(map(str, driver))}; expected "
                f"{'.'.join(map(str, _OLDEST_DRIVER))} or newer; update the driver"
            )
        if not (warp.is_cuda_available() and torch.cuda.is_available()):
            lacking = "torch" if warp.is_cuda_available() else "Warp"
            raise QuadrupedError(
                f"--device: {name}: {lacking} finds no CUDA GPU on this machine; check that nvidia-smi shows one, and "
                f"that torch is a CUDA build (torch {torch.__version__} is installed), or use --device cpu"
            )
    try:
        return warp.get_device(name)
    except (RuntimeError, ValueError) as error:
        raise QuadrupedError(f"--device: {name}: {error}; nvidia-smi lists the GPUs") from error


def _view(array: Any) -> torch.Tensor:
    return warp.to_torch(array)
