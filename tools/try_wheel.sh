#!/bin/sh
# Installs a wheel or a source distribution beside nothing else, and runs the smoke test on it:
#   try_wheel.sh here FILE       in an empty environment, without Rust
#   try_wheel.sh offline FILE    built there from the source distribution, with what cargo has downloaded
#   try_wheel.sh arm64 FILE      emulated, with Debian's Python
#   try_wheel.sh pyodide FILE    the compiled core, in Node.js
# It needs .venv (tools/setup.sh).
set -eu
cd "$(dirname "$0")/.."

way=$1 file=$2
folder=$PWD/target/wheels/$way
uv=.venv/bin/uv
rm -rf "$folder"
mkdir -p "$folder"

environment() { "$(tools/toolchain.sh)" -m venv "$folder"; }

case $way in
here)
    environment
    $uv pip install --quiet --python "$folder/bin/python" --only-binary :all: "$file"
    env -i PATH=/usr/bin:/bin "$folder/bin/python" tools/smoke_test.py
    ;;
offline)
    environment
    $uv pip install --quiet --python "$folder/bin/python" --constraint constraints.txt \
        --requirements pyproject.toml maturin
    # From nothing: caches of pip and cargo may hold what another file of this name was built into.
    unset CARGO_TARGET_DIR
    PATH=$folder/bin:$PATH CARGO_NET_OFFLINE=true "$folder/bin/python" -m pip install --quiet \
        --disable-pip-version-check --no-cache-dir --no-index --no-build-isolation "$file"
    "$folder/bin/python" tools/smoke_test.py
    ;;
arm64)
    debian=$(tools/debian_arm64.sh)
    version=$(cd "$debian/usr/bin" && echo python3.*[0-9])
    $uv pip install --quiet --target "$folder" --only-binary :all: \
        --python-platform aarch64-manylinux2014 --python-version "${version#python}" "$file"
    "$debian/usr/bin/qemu-aarch64-static" -L "$debian" -E PYTHONPATH="$folder" \
        "$debian/usr/bin/$version" -S tools/smoke_test.py
    ;;
pyodide)
    # A release of Pyodide (as in docs.yml) whose binary interface is that of MATURIN_PYEMSCRIPTEN_PLATFORM_VERSION.
    tools/node.sh npm install --silent --no-save --prefix "$folder" pyodide@314.0.7
    tools/node.sh node "$PWD/tools/smoke_test_pyodide.mjs" \
        "$folder/node_modules/pyodide/pyodide.mjs" "$(realpath "$file")" "$PWD"
    ;;
*)
    echo "rimroll: unknown way: $way" >&2
    exit 2
    ;;
esac
