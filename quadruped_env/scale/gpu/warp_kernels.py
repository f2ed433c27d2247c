"""Kernels of the driver on MuJoCo Warp."""

import warp as wp

LARGEST = wp.constant(1.0e10)
"""Largest position, velocity or acceleration of a valid state: MuJoCo's mjMAXVAL."""


@wp.func  # type: ignore[untyped-decorator]
def is_valid(value: float) -> bool:
    """False for NaN, infinity, and values over MuJoCo's limit."""
    return wp.abs(value) <= LARGEST


@wp.kernel(enable_backward=False)  # type: ignore[untyped-decorator]
def restart_diverged(
    initial_qpos: wp.array[float],
    qacc: wp.array2d[float],
    qpos: wp.array2d[float],
    qvel: wp.array2d[float],
    qacc_warmstart: wp.array2d[float],
    diverged: wp.array[bool],
) -> None:
    """Put worlds with an invalid state at rest in the model's initial position, as MuJoCo does, and mark them."""
    world = wp.tid()
    valid = bool(True)  # noqa: UP018  (a literal would be a constant of the kernel)
    for i in range(qpos.shape[1]):
        valid = valid and is_valid(qpos[world, i])
    for i in range(qvel.shape[1]):
        valid = valid and is_valid(qvel[world, i]) and is_valid(qacc[world, i])
    if not valid:
        diverged[world] = True
        for i in range(qpos.shape[1]):
            qpos[world, i] = initial_qpos[i]
        for i in range(qvel.shape[1]):
            qvel[world, i] = 0.0
            qacc_warmstart[world, i] = 0.0
