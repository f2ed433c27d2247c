"""Randomizations of the task: their laws, their random numbers, and the envs and episodes that they apply to."""
