"""Bugs that can be planted in a source file, by the operators of Cosmic Ray.

None is planted in a type annotation, in a `raise` statement or in an f-string.
"""

import difflib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Final

from cosmic_ray.ast import ast_nodes, get_ast
from cosmic_ray.mutating import MutationVisitor
from cosmic_ray.operators.operator import Operator
from cosmic_ray.operators.provider import OperatorProvider
from parso.python.tree import Keyword

_BINARY: Final = (
    "Add_Sub Sub_Add Mul_Div Div_Mul FloorDiv_Mul Mod_Mul Pow_Mul RShift_LShift LShift_RShift BitOr_BitAnd "
    "BitAnd_BitOr BitXor_BitAnd"
)
_COMPARISON: Final = "Eq_NotEq NotEq_Eq Lt_LtE Lt_GtE LtE_Lt LtE_Gt Gt_GtE Gt_LtE GtE_Gt GtE_Lt Is_IsNot IsNot_Is"
OPERATORS: Final = (
    *(f"ReplaceBinaryOperator_{pair}" for pair in _BINARY.split()),
    *(f"ReplaceComparisonOperator_{pair}" for pair in _COMPARISON.split()),
    *(f"ReplaceUnaryOperator_Delete_{name}" for name in ("USub", "Not", "Invert")),
    *("ReplaceTrueWithFalse", "ReplaceFalseWithTrue", "ReplaceAndWithOr", "ReplaceOrWithAnd", "AddNot"),
    *("ReplaceBreakWithContinue", "ReplaceContinueWithBreak", "ExceptionReplacer", "ZeroIterationForLoop"),
    *("NumberReplacer", "RemoveStatement"),
)
"""Names of the operators, two or fewer for each place. All but `RemoveStatement` are Cosmic Ray's."""
_BINARY_PARENTS: Final = {"arith_expr", "term", "expr", "and_expr", "xor_expr", "shift_expr", "power"}


class RemoveStatement(Operator):
    """Removes a call whose result is not used, an assignment to an item, or one such as `x += 1`."""

    def mutation_positions(self, node: Any) -> Iterator[tuple[Any, Any]]:
        """Start and end of the statement."""
        if getattr(node.parent, "type", "") == "simple_stmt" and (
            _ends_with(node, "(")
            or (node.type == "expr_stmt" and (_ends_with(node.children[0], "[") or _is_augmented(node)))
        ):
            yield node.start_pos, node.end_pos

    def mutate(self, node: Any, index: int) -> Any:
        """The statement that does nothing."""
        return Keyword("pass", node.start_pos, node.get_first_leaf().prefix)

    @classmethod
    def examples(cls) -> tuple[Any, ...]:
        """None: Cosmic Ray tests only its own operators."""
        return ()


@dataclass(frozen=True)
class Mutant:
    """One planted bug."""

    path: str
    """Source file, relative to the current directory, with `/`"""
    line: int
    column: int
    operator: str
    occurrence: int
    """Number of the place among the operator's places in the file"""

    @property
    def name(self) -> str:
        """For example `quadruped_env.task.rewards:57:12:ReplaceBinaryOperator_Add_Sub`."""
        return f"{module_name(self.path)}:{self.line}:{self.column}:{self.operator}"

    def code(self) -> str:
        """Source of the whole file with the bug."""
        source = Path(self.path).read_text(encoding="utf-8")
        return str(MutationVisitor.mutate_code(source, _operator(self.operator), self.occurrence))

    def diff(self) -> str:
        """Changed lines, `- before` and `+ after`."""
        before = Path(self.path).read_text(encoding="utf-8").splitlines()
        lines = list(difflib.unified_diff(before, self.code().splitlines(), n=0, lineterm=""))[2:]
        return "\n".join(f"{line[0]} {line[1:].strip()}" for line in lines if line[0] in "-+")


def module_name(path: str) -> str:
    """Name of the module in a file."""
    return path.removesuffix(".py").removesuffix("/__init__").replace("/", ".")


def mutants_of(path: str) -> list[Mutant]:
    """All bugs that can be planted in a file, in the order of its lines."""
    nodes = list(ast_nodes(get_ast(Path(path).read_text(encoding="utf-8"))))
    found: dict[str, Mutant] = {}
    for name in OPERATORS:
        places = [(node, start) for node in nodes for start, _ in _operator(name).mutation_positions(node)]
        for occurrence, (node, (line, column)) in enumerate(places):
            mutant = Mutant(path, line, column, name, occurrence)
            # One number is two occurrences at one place, plus and minus one. The first is taken.
            if mutant.name not in found and _is_place(node, name):
                found[mutant.name] = mutant
    return sorted(found.values(), key=lambda mutant: (mutant.line, mutant.column, mutant.operator))


@cache
def _operator(name: str) -> Operator:
    return RemoveStatement() if name == RemoveStatement.__name__ else OperatorProvider()[name]()


def _is_place(node: Any, operator: str) -> bool:
    if operator.startswith("ReplaceBinary") and node.parent.type not in _BINARY_PARENTS:
        return False
    if operator == "AddNot" and node.children[2 if node.type == "test" else 1].type == "comparison":
        return False  # The comparison itself is replaced by its opposite.
    if operator == "ExceptionReplacer" and "." in node.get_code():
        return False  # Cosmic Ray replaces no dotted names.
    while (parent := node.parent) is not None:
        annotation = (parent.type == "annassign" and node is parent.children[1]) or (
            parent.type == "funcdef" and node is parent.annotation
        )
        if annotation or parent.type in ("raise_stmt", "fstring", "tfpdef"):
            return False
        node = parent
    return True


def _ends_with(node: Any, bracket: str) -> bool:
    return node.type in ("atom_expr", "power") and getattr(node.children[-1], "children", "x")[0] == bracket


def _is_augmented(node: Any) -> bool:
    return node.children[1].type == "operator" and node.children[1].value != "="
