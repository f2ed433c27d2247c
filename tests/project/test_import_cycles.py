"""The package has no import cycle, not even one through several files, in functions or for type checking."""

import grimp


def circular_imports(package):
    """The imports (importer, imported) of a package that are part of a cycle."""
    graph = grimp.build_graph(package, cache_dir=None)
    pairs = ((module, found) for module in graph.modules for found in graph.find_modules_directly_imported_by(module))
    return {(module, found) for module, found in pairs if graph.chain_exists(importer=found, imported=module)}


def test_package_imports_form_no_cycle():
    assert circular_imports("quadruped_env") == set(), "move the shared code below its users"


def test_circular_imports_in_functions_and_for_types_are_found(tmp_path, monkeypatch):
    files = {
        "__init__": "",
        "a": "def f():\n    from cycles_fixture import b\n    return b\n",
        "b": "from cycles_fixture.c import x\n",
        "c": "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from cycles_fixture import a\nx = 1\n",
        "d": "from cycles_fixture import a\n",
    }
    (tmp_path / "cycles_fixture").mkdir()
    for name, text in files.items():
        (tmp_path / "cycles_fixture" / f"{name}.py").write_text(text)
    monkeypatch.syspath_prepend(tmp_path)
    pairs = {("a", "b"), ("b", "c"), ("c", "a")}
    expected = {tuple(f"cycles_fixture.{name}" for name in pair) for pair in pairs}
    assert circular_imports("cycles_fixture") == expected
