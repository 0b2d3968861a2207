# On a new machine with Python 3.11 or newer: `make run` and `make test`.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin

.PHONY: run test lint check docs benchmarks clean

run: $(VENV)/.main
	$(BIN)/viscodesign simulate configs/leg.yaml

test: $(VENV)/.dev
	$(BIN)/python -m pytest -n 2 --dist worksteal

lint: $(VENV)/.dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

check: lint
	$(BIN)/python -m pytest -n 2 --dist worksteal -x tests/unit tests/contract

docs: $(VENV)/.dev
	$(BIN)/python -m sphinx -W --keep-going -q -b html docs site

benchmarks: $(VENV)/.dev
	$(BIN)/python benchmarks/all.py

$(VENV)/.main: pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade pip
	$(BIN)/python -m pip install --quiet --editable .
	touch $@

$(VENV)/.dev: $(VENV)/.main
	$(BIN)/python -m pip install --quiet --editable '.[dev]'
	touch $@

clean:
	rm -rf $(VENV) site
