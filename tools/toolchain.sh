#!/bin/sh
# Prints the Python for building rimroll. If a tool is missing or too old, it says in one line what
# to install, and fails. PYTHON=... names the Python to use.
cd "$(dirname "$0")/.." || exit

fail() {
    echo "rimroll: $*" >&2
    exit 1
}

# at_least 1.95 1.85: whether the first version is at least the second
at_least() {
    [ "${1%%.*}" -gt "${2%%.*}" ] || { [ "${1%%.*}" -eq "${2%%.*}" ] && [ "${1#*.}" -ge "${2#*.}" ]; }
}

min_rust=$(sed -n 's/^rust-version = "\([0-9]*\.[0-9]*\).*/\1/p' Cargo.toml)
min_python=$(sed -n 's/^requires-python = ">=\([0-9.]*\)".*/\1/p' pyproject.toml)

get_rust="install it with rustup (https://rustup.rs), then run make again"
command -v cargo >/dev/null && command -v rustc >/dev/null ||
    fail "Rust is missing: rimroll needs $min_rust or newer; $get_rust"
rust=$(rustc --version 2>/dev/null | sed -n 's/^rustc \([0-9]*\.[0-9]*\).*/\1/p')
[ -n "$rust" ] || fail "rustc is there but does not run; try: rustup default stable"
at_least "$rust" "$min_rust" ||
    fail "Rust $rust is too old: rimroll needs $min_rust or newer; run: rustup update stable (or $get_rust)"
command -v cc >/dev/null ||
    fail "a C linker (cc) is missing, and Rust needs one; on Debian or Ubuntu: apt install gcc libc6-dev; on macOS: xcode-select --install"

# The first Python that is new enough and can make a virtual environment.
if [ -n "${PYTHON:-}" ]; then set -- "$PYTHON"; else set -- python3 python3.14 python3.13 python3.12 python3.11; fi
without_venv='' too_old=''
for python; do
    version=$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null) || continue
    if ! at_least "$version" "$min_python"; then
        too_old=${too_old:-$version}
    elif ! "$python" -c 'import ensurepip, venv' 2>/dev/null; then
        without_venv=${without_venv:-$version} # Debian has a separate package for it
    else
        # Not that of an active virtual environment.
        exec "$python" -c 'import sys; print(getattr(sys, "_base_executable", sys.executable))'
    fi
done
[ -z "$without_venv" ] ||
    fail "Python $without_venv lacks its venv module; on Debian or Ubuntu: apt install python$without_venv-venv"
get_python="install Python $min_python or newer (on Debian or Ubuntu: apt install python3 python3-venv), or name one: make PYTHON=/path/to/python3"
[ -z "$too_old" ] || fail "Python $too_old is too old: $get_python"
fail "${PYTHON:-Python} is missing: $get_python"
