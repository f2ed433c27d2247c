"""A policy in a second engine: the same episodes in MuJoCo and, from the robot's URDF alone, in Drake."""
