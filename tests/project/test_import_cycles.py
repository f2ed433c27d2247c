"""The package has no import cycle, not even one through several files or in functions."""

import grimp


def circular_imports(package):
    """The imports (importer, imported) of a package that are part of a cycle."""
    graph = grimp.build_graph(package, cache_dir=None, exclude_type_checking_imports=True)
    pairs = ((module, found) for module in graph.modules for found in graph.find_modules_directly_imported_by(module))
    return {(module, found) for module, found in pairs if graph.chain_exists(importer=found, imported=module)}


def test_package_imports_form_no_cycle():
    assert circular_imports("quadruped_env") == set(), "move the shared code below its users"
