"""Many trainings at once: seeds of one config, and searches over the settings of task and training.

A sweep is a directory. A worker is any process that sees the directory and does its trials, one after another.
"""
