# Results are in .venv, web/node_modules, target, out, dist and python/rimroll/page; each is rebuilt only if
# its sources have changed. Scripts for the set-up are in tools/.

# The sources of crates.
sources = Cargo.toml $(wildcard Cargo.lock) $(shell find $(1:=/Cargo.toml) $(1:=/src) -type f)

RUST    := $(call sources,crates/rimroll crates/rimroll-py)
WASM    := $(call sources,crates/rimroll crates/rimroll-wasm)
WEB     := $(shell find web/src web/public web/licences -type f -not -name '*.wasm') $(wildcard web/*.html web/*.ts web/*.json)
PACKAGE := $(shell find python/rimroll -type f -not -path '*/__pycache__/*' -not -path '*/page/*')
REPORT  := out/paper/index.html
PAGE    := python/rimroll/page/index.html

# NumPy and OpenBLAS compute as on a processor without AVX2, AVX-512 and fused operations, which changes last bits.
OTHER_PROCESSOR := NPY_DISABLE_CPU_FEATURES="X86_V3 X86_V4 AVX512_ICL AVX512_SPR" OPENBLAS_CORETYPE=Prescott

.DELETE_ON_ERROR:
.PHONY: help demo web docs dev check test soak bench census scorecard wheels lint audit semver msrv clean toolchain

help: ## list the targets (the default)
	@sed -n 's/^\([a-z]*\):.*## /make \1	/p' Makefile

demo: $(REPORT) ## redo the paper's figures and tables as one page
	@echo "The report is $(REPORT): open it in a browser."

web: $(PAGE) ## build the lab, the page that `rimroll lab` opens
	@echo "The page is $(PAGE): .venv/bin/rimroll lab opens it."

docs: $(REPORT) $(PAGE) .venv/.docs $(if $(PYODIDE),.venv/.notebooks) ## build the documentation site: out/docs
	tools/build_docs.sh

# The next target that needs the optimised extension builds it again.
dev: .venv/.packages ## build the extension quickly, with little optimisation, for work on the core
	tools/build_extension.sh --profile quick
	@rm -f .venv/.extension

check: lint .venv/.extension web/src/core/rimroll.wasm ## lint, and run the tests that are quick and find most mistakes
	cargo test --package rimroll --lib
	.venv/bin/python -m pytest -m "not slow and not soak" tests/api tests/cli tests/examples tests/mechanics
	tools/test_page.sh --project modules

test: .venv/.extension $(PAGE) ## run the tests of the core (Rust), of the package (Python) and of the page (in a browser)
	cargo test
	.venv/bin/python -m pytest
	tools/test_page.sh

soak: .venv/.extension $(PAGE) ## run all tests, with four times as many random examples, as before a release
	RIMROLL_CASES=4 cargo test
	.venv/bin/python -m pytest -m "" --hypothesis-profile soak tests score/tests
	$(OTHER_PROCESSOR) .venv/bin/python -m pytest tests/docs tests/ground
	.venv/bin/python bench/shaken_census.py --number 300
	RIMROLL_CASES=4 tools/test_page.sh

bench: .venv/.extension ## measure against the peers, into bench/results (a quarter of an hour)
	bench/install.sh
	.venv/bin/python bench/against_peers.py

census: .venv/.extension ## compare both engines from 100 000 wild starts (ten minutes)
	.venv/bin/python bench/census.py

scorecard: .venv/.extension ## measure physics engines again, for docs/physics-engines.md (an hour)
	.venv/bin/rimroll score rimroll mujoco pybullet rapier dart exudyn drake --install -o score/results
	.venv/bin/rimroll score newton --install --dt 2e-3,1e-3,5e-4,2e-4 --no-checks --time-limit 300s -o score/results
	.venv/bin/python -m rimroll_score.search mujoco pybullet rapier dart exudyn drake -o score/results
	.venv/bin/python -m rimroll_score.tables score/results docs/physics-engines.md

lint: .venv/.packages web/node_modules/.installed ## check format, lints, types, spelling, workflows and the links of the Rust documentation
	cargo fmt --all --check
	PYO3_PYTHON="$(CURDIR)/.venv/bin/python" cargo clippy --workspace --all-targets -- -D warnings
	cargo clippy --package rimroll-wasm --features ground -- -D warnings
	RUSTDOCFLAGS="-D warnings" PYO3_PYTHON="$(CURDIR)/.venv/bin/python" cargo doc --workspace --no-deps
	RUSTDOCFLAGS="-D warnings" PYO3_PYTHON="$(CURDIR)/.venv/bin/python" cargo doc --workspace --no-deps --document-private-items
	.venv/bin/ruff check
	.venv/bin/ruff format --check
	.venv/bin/mypy
	.venv/bin/typos
	.venv/bin/zizmor --offline --quiet --strict-collection .github
	tools/node.sh tsc --noEmit --incremental --tsBuildInfoFile node_modules/.cache/tsc.json
	tools/node.sh prettier --cache --check .

wheels: .venv/.wheels $(PAGE) ## build the source distribution and wheels: dist, score/dist (all, or make wheels WHEELS="sdist pyodide")
	.venv/bin/python tools/build_wheels.py $(WHEELS)
	.venv/bin/python tools/build_score.py

audit: ## check licences and advisories of what the crates depend on (needs cargo-deny)
	cargo deny --workspace check

semver: ## compare the crate's interface with that of the last release (needs cargo-semver-checks)
	tools/semver.sh

msrv: ## compile with the oldest Rust that Cargo.toml names
	tools/oldest_rust.sh

clean: ## remove everything that was installed or built
	rm -rf .venv web/node_modules target out dist score/dist
	rm -rf python/rimroll/page python/rimroll/_core.*so web/src/core/*.wasm

$(REPORT): $(PACKAGE) .venv/.extension
	.venv/bin/rimroll reproduce --output $(@D)

$(PAGE): $(WEB) web/src/core/rimroll.wasm web/node_modules/.installed
	tools/node.sh vite build --logLevel warn
	tools/node.sh vite build --logLevel warn --mode alone  # for rimroll.lab

# The script also builds rimroll-ground.wasm.
web/src/core/rimroll.wasm: $(WASM) tools/build_wasm.sh tools/debian_rust.sh | toolchain
	tools/build_wasm.sh

# If the machine has no Node.js, that in .venv is used.
web/node_modules/.installed: web/package.json web/package-lock.json web/.npmrc tools/node.sh | .venv/.packages
	tools/node.sh npm ci --silent
	@touch $@

.venv/.docs: .venv/.packages
	.venv/bin/uv pip install --quiet --python .venv/bin/python --constraint constraints.txt --group docs
	@touch $@

.venv/.notebooks: .venv/.packages
	.venv/bin/uv pip install --quiet --python .venv/bin/python --constraint constraints.txt --group notebooks
	@touch $@

.venv/.wheels: .venv/.packages
	.venv/bin/uv pip install --quiet --python .venv/bin/python --constraint constraints.txt --group wheels
	@touch $@

.venv/.extension: $(RUST) tools/build_extension.sh .venv/.packages
	tools/build_extension.sh
	@touch $@

.venv/.packages: pyproject.toml $(wildcard score/pyproject.toml) constraints.txt tools/setup.sh | toolchain
	tools/setup.sh

# .venv contains its own path: in a tree that was moved or copied it is created again.
ifneq ($(shell cat .venv/.packages 2>/dev/null),$(CURDIR))
.PHONY: .venv/.packages
endif

toolchain:
	@tools/toolchain.sh >/dev/null
