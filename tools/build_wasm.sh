#!/bin/sh
# Compiles the Rust core to WebAssembly for the page: without tables that move, and with them for a visitor who
# shakes the floor. The standard library for that target comes from
# rustup, or from Debian if rustup has none; RIMROLL_WASM=rustup or =debian chooses one. Results of the
# core are the same to the last bit with either.
set -eu
cd "$(dirname "$0")/.."

target=wasm32-unknown-unknown
# SIMD with two numbers, which browsers support since 2021 and Safari since 2023: the operations are
# the same, and so are the bits. Functions that must be fast are inlined by attribute; a lower threshold
# for the others makes the file an eighth smaller, and dry friction a twentieth slower.
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-C target-feature=+simd128 -C llvm-args=-inline-threshold=5"
build() {
    compile rimroll-ground.wasm "$@" --features ground
    # The last, for it is the one that make compares with the sources.
    compile rimroll.wasm "$@"
}
compile() {
    file=$1
    shift
    cargo build "$@" --quiet --package rimroll-wasm --profile page --target "$target"
    cp "${CARGO_TARGET_DIR:-target}/$target/page/rimroll_wasm.wasm" "web/src/core/$file"
}

# A Rust that is not from rustup may also have the target.
has_target() {
    [ -d "$(rustc --print target-libdir --target "$target")" ] ||
        rustup target add "$target" >/dev/null 2>&1
}

source=${RIMROLL_WASM:-any}
if [ "$source" != debian ] && has_target; then
    # Debian's Rust brings no linker for it; Debian's lld does.
    ls "$(rustc --print sysroot)"/lib/rustlib/*/bin/rust-lld >/dev/null 2>&1 ||
        export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld
    build
elif [ "$source" != rustup ] && command -v apt-get >/dev/null && command -v dpkg >/dev/null; then
    rust=$(tools/debian_rust.sh)
    # A stable compiler builds its own standard library only with this variable.
    export RUSTC_BOOTSTRAP=1 RUSTC="$rust/usr/bin/rustc"
    export LD_LIBRARY_PATH="$rust/usr/lib/$(uname -m)-linux-gnu"
    export CARGO_TARGET_DIR=target/debian
    export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER="$rust/usr/bin/wasm-ld"
    build -Zbuild-std=std,panic_abort
else
    echo "rimroll: Rust cannot compile to WebAssembly here; run: rustup target add $target" >&2
    exit 1
fi
