#!/bin/sh
# Compiles the Rust core to WebAssembly, where the page looks for it.
set -eu
cd "$(dirname "$0")/.."

target=wasm32-unknown-unknown
rustup target add "$target" >/dev/null 2>&1
cargo build --quiet --package rimroll-wasm --profile page --target "$target"
cp "target/$target/page/rimroll_wasm.wasm" web/src/core/rimroll.wasm
