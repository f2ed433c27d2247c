"""Check that an expression in a xacro file is arithmetic: names, numbers, operators, and a few functions."""

import ast
import math
from typing import Final

from quadruped_env.errors import QuadrupedError, short

_NODES: Final = (
    *(ast.Expression, ast.Constant, ast.Name, ast.Load, ast.Attribute, ast.Subscript, ast.Slice, ast.Call),
    *(ast.BinOp, ast.UnaryOp, ast.BoolOp, ast.Compare, ast.IfExp, ast.List, ast.Tuple, ast.Dict),
    *(ast.operator, ast.unaryop, ast.boolop, ast.cmpop),
)
_BUILT_IN: Final = (
    *("abs", "all", "any", "bool", "dict", "float", "int", "len", "list"),
    *("max", "min", "round", "sorted", "str", "sum", "tuple"),
)
_MATH: Final = tuple(name for name in vars(math) if name not in ("comb", "factorial", "perm", "prod"))
_METHODS: Final = ("startswith", "endswith", "lower", "upper", "strip", "split")
_FUNCTIONS: Final = {
    *_BUILT_IN,
    *_MATH,
    *(f"python.{name}" for name in _BUILT_IN),
    *(f"math.{name}" for name in _MATH),
    *("load_yaml", "xacro.load_yaml", "xacro.arg", "xacro.dotify"),
}
_MAX_POWER: Final = 16
"""Largest exponent: whole powers of whole powers can fill the memory."""


def check_arithmetic(text: str) -> None:
    """Raise a QuadrupedError for an expression that is more than arithmetic, so that evaluating it could run code."""
    try:
        tree = ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError, MemoryError) as error:
        raise QuadrupedError(f"{short(text)} is no expression") from error
    for node in ast.walk(tree):
        if not _is_plain(node):
            raise QuadrupedError(f"the expression {short(text)} is more than arithmetic, so it is not evaluated")


def _is_plain(node: ast.AST) -> bool:
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return not name.startswith("_")
        case ast.Call(func=function):
            method = isinstance(function, ast.Attribute) and function.attr in _METHODS
            return not node.keywords and (method or ast.unparse(function) in _FUNCTIONS)
        case ast.BinOp(op=ast.Pow(), right=exponent):
            number = exponent.operand if isinstance(exponent, ast.UnaryOp) else exponent
            return (
                isinstance(number, ast.Constant)
                and isinstance(number.value, int | float)
                and number.value <= _MAX_POWER
            )
        case ast.BinOp(op=ast.Mod() | ast.Mult(), left=ast.Constant(value=str())):
            return False  # formats texts, or repeats them
    return isinstance(node, _NODES)
