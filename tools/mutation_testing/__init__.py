"""Planted bugs: where they can be planted, which tests reach them, and whether a test finds them."""
