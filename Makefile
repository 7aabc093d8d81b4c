# What is installed and built is kept in .venv, target and out; each is made anew only when what it
# is made from has changed. The work of setting up lives in tools/.

CRATES  := crates/rimroll crates/rimroll-py
RUST    := Cargo.toml $(wildcard Cargo.lock) $(shell find $(CRATES:=/Cargo.toml) $(CRATES:=/src))
PACKAGE := $(shell find python/rimroll -type f -not -path '*/__pycache__/*')
REPORT  := out/paper/index.html

.DELETE_ON_ERROR:
.PHONY: help demo test bench coverage lint clean toolchain

help: ## say what can be made (the default)
	@sed -n 's/^\([a-z]*\):.*## /make \1	/p' Makefile

demo: $(REPORT) ## redo the paper's figures and tables as one page
	@echo "The report is $(REPORT): open it in a browser."

test: .venv/.extension ## run the tests of the core (Rust) and of the package (Python)
	cargo test
	.venv/bin/python -m pytest

bench: .venv/.extension ## measure against the peers, into bench/results (a quarter of an hour)
	bench/install.sh
	.venv/bin/python bench/against_peers.py

coverage: .venv/.extension ## measure how often the fit's intervals hold the truth (twenty minutes)
	.venv/bin/python bench/coverage.py

lint: .venv/.packages ## check format, lints and types
	cargo fmt --all --check
	PYO3_PYTHON="$(CURDIR)/.venv/bin/python" cargo clippy --workspace --all-targets -- -D warnings
	.venv/bin/ruff check
	.venv/bin/ruff format --check
	.venv/bin/mypy

clean: ## remove all that was installed, built or made
	rm -rf .venv target out python/rimroll/_core.*so

$(REPORT): $(PACKAGE) .venv/.extension
	.venv/bin/rimroll reproduce --output $(@D)

.venv/.extension: $(RUST) tools/build_extension.sh .venv/.packages
	tools/build_extension.sh
	@touch $@

.venv/.packages: pyproject.toml constraints.txt tools/setup.sh | toolchain
	tools/setup.sh

# .venv knows its place by heart: in a tree that was moved or copied it is made anew.
ifneq ($(shell cat .venv/.packages 2>/dev/null),$(CURDIR))
.PHONY: .venv/.packages
endif

toolchain:
	@tools/toolchain.sh >/dev/null
