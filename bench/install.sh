#!/bin/sh
# Installs rimroll's peers for bench/: Python packages into out/bench/venv, compiled ones beside it.
# Peers that cannot be installed are left out with a message.
set -eu
cd "$(dirname "$0")/.."
built=$PWD/out/bench
mkdir -p "$built"

say() {
    echo "bench: $*"
}

if [ "$(cat "$built/venv/.installed" 2>/dev/null)" != "$(cat bench/peers.txt)" ]; then
    say "installing SciPy, heyoka, numba and diffrax"
    .venv/bin/uv venv --quiet --clear --python .venv/bin/python "$built/venv"
    .venv/bin/uv pip install --quiet --python "$built/venv/bin/python" --requirements bench/peers.txt
    cp bench/peers.txt "$built/venv/.installed"
fi

say "building ode_solvers and diffsol"
(
    cd bench/peers-rs
    CARGO_TARGET_DIR="$built/peers-rs" RUSTFLAGS="-C target-cpu=native" cargo build --quiet --release --locked
)
(
    cd bench/core-rs
    CARGO_TARGET_DIR="$built/core-rs" cargo build --quiet --release
)

# Boost's part is headers only.
has_boost() {
    echo '#include <boost/numeric/odeint.hpp>' | g++ -std=c++17 -fsyntax-only -x c++ - 2>/dev/null
}
if ! has_boost && command -v apt-get >/dev/null && [ "$(id -u)" -eq 0 ]; then
    say "installing Boost's headers"
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends libboost-dev g++ >/dev/null
fi
if has_boost; then
    say "building Boost.odeint"
    g++ -std=c++17 -O3 -march=native -o "$built/boost_odeint" bench/peers-cpp/boost_odeint.cpp
else
    rm -f "$built/boost_odeint"
    say "Boost.odeint is left out: it needs g++ and Boost's headers (Debian: g++ libboost-dev)"
fi
