#!/bin/sh
# Create a virtual environment, and install this checkout with an extra, at the versions of constraints.txt.
# 'make install', 'make docs' and 'make dev' run it; the Makefile explains PYTHON, VENV and TORCH_INDEX.
set -eu
cd "$(dirname "$0")/.."
extra=$1
oldest=3.11

version() {
    "$1" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null
}
recent() { # a program on PATH may start nothing, as pyenv's do
    "$1" -c "import sys; sys.exit(sys.version_info < (${oldest%.*}, ${oldest#*.}))" 2>/dev/null
}
installed() {
    "$VENV/bin/python" -c "import importlib.metadata as m; print(m.version('$1'))" 2>/dev/null
}
pip() {
    "$VENV/bin/python" -m pip --quiet --disable-pip-version-check "$@"
}
fail() {
    echo "error: $*" >&2
    exit 2
}

usable=
if "$VENV/bin/python" -m pip --version >/dev/null 2>&1 && recent "$VENV/bin/python"; then
    usable=$VENV/bin/python
fi
python=
for candidate in ${PYTHON:-$usable python3 python3.11 python3.12 python3.13 python3.14}; do
    if recent "$candidate"; then
        python=$candidate
        break
    fi
done
if [ -z "$python" ]; then
    first=${PYTHON:-python3}
    found=$(version "$first") && first="$first is Python $found" || first="$first does not start"
    fail "$first, and $oldest or later is needed. Install one next to it, with 'uv python install 3.12' or, on Ubuntu," \
        "'sudo add-apt-repository ppa:deadsnakes/ppa && sudo apt install python3.12-venv', and run make again." \
        "PYTHON=/path/to/python names one that is not on PATH."
fi

# One that is not usable, such as one of an older Python, would otherwise keep its Python for ever.
if [ -z "$usable" ] || [ "$(version "$usable")" != "$(version "$python")" ]; then
    if [ -e "$VENV" ] && [ ! -e "$VENV/pyvenv.cfg" ]; then
        fail "$VENV exists and is not a virtual environment; remove it, or name another place with VENV="
    fi
    echo "creating $VENV with $python ($(version "$python"))"
    "$python" -m venv --clear "$VENV"
fi

# pip installs MuJoCo 4 and then removes the files of an older one, which have the same names.
case $(installed mujoco) in [0-3].*) pip uninstall -y mujoco ;; esac

install_torch() {
    torch=$(sed -n 's/^torch==//p' constraints.txt)
    case $(installed torch) in "$torch" | "$torch+"*) TORCH_INDEX= ;; esac
    # PyPI has no version with a '+': this finds only a CPU build that pip can have elsewhere, such as in its find-links.
    case $TORCH_INDEX in */cpu) pip install -c constraints.txt "torch==$torch+cpu" 2>/dev/null && TORCH_INDEX= ;; esac
    if [ -n "$TORCH_INDEX" ]; then
        # Its dependencies come with the package's, from pip's own index.
        pip install --no-deps --retries 1 --index-url "$TORCH_INDEX" "torch==$torch" ||
            fail "no torch $torch for Python $(version "$VENV/bin/python") from $TORCH_INDEX. 'make install" \
                "TORCH_INDEX=https://...' takes it from another index, and 'make install TORCH_INDEX=' from pip's own," \
                "which for Linux has a build with 2.7 GB of CUDA."
    fi
}
# First, since as a dependency PyPI's build would come. An installed build is kept, whatever it is for.
[ "$extra" = docs ] || install_torch

# Not quiet: it takes minutes, and where no version fits, only what comes before the error names the requirement.
"$VENV/bin/python" -m pip --disable-pip-version-check install -c constraints.txt -e ".[$extra]"
"$VENV/bin/python" -c 'import quadruped_env'
