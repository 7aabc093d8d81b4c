#!/bin/sh
# Recreates .venv and installs the Python packages that rimroll and its tools need, at the versions
# of constraints.txt. When it is complete, .venv/.packages holds the path of this tree.
set -eu
cd "$(dirname "$0")/.."

python=$(tools/toolchain.sh)
echo "Installing Python packages into .venv, which takes about a minute ..."
rm -rf .venv
"$python" -m venv .venv
# pip fetches uv, and uv, which is many times faster, fetches the rest.
.venv/bin/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt uv
.venv/bin/uv pip install --quiet --python .venv/bin/python --constraint constraints.txt \
    --requirements pyproject.toml --group dev
if [ -d score ]; then
    .venv/bin/uv pip install --quiet --python .venv/bin/python --no-deps \
        --build-constraints constraints.txt --editable score
fi
pwd -P >.venv/.packages
