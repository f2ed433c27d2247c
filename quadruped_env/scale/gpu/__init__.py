"""The task on a GPU: MuJoCo Warp as its driver, PyTorch tensors as its arrays, and a training with rsl-rl."""
