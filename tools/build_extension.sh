#!/bin/sh
# Compiles the Rust core into python/rimroll/ and links .venv to that folder. With `--profile quick`
# it compiles quickly and runs slowly.
set -eu
cd "$(dirname "$0")/.."

# maturin finds the environment and its tools through these variables.
unset CONDA_PREFIX
VIRTUAL_ENV=$PWD/.venv
PATH=$VIRTUAL_ENV/bin:$PATH
UV_CONSTRAINT=constraints.txt
export VIRTUAL_ENV PATH UV_CONSTRAINT
echo "Compiling the Rust core, which takes some minutes the first time ..."
[ $# -gt 0 ] || set -- --release
maturin develop --quiet "$@" --uv
