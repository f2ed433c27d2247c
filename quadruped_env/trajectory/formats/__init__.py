"""Readers and writers, one module per file format.

A reader is a function `read...(reading)` that yields `Rows`; a writer takes them. None of them knows `JointTrajectory`.
"""
