"""One training on several processes, the ranks: PPO that averages gradients over `torch.distributed`.

Each rank has its share of the envs, and all take the same gradient steps with the same weights. `processes` starts the
ranks on this machine, `ray_cluster` on a Ray cluster, and `torchrun` those of torchrun or Slurm.
"""
