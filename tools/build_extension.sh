#!/bin/sh
# Compiles the Rust core into python/rimroll/ and makes .venv see that folder as the package. With
# `--profile quick` it is compiled soon and runs slowly.
set -eu
cd "$(dirname "$0")/.."

# maturin finds the environment and its tools by these.
unset CONDA_PREFIX
VIRTUAL_ENV=$PWD/.venv
PATH=$VIRTUAL_ENV/bin:$PATH
UV_CONSTRAINT=constraints.txt
export VIRTUAL_ENV PATH UV_CONSTRAINT
echo "Compiling the Rust core, which takes some minutes the first time ..."
[ $# -gt 0 ] || set -- --release
maturin develop --quiet "$@" --uv
