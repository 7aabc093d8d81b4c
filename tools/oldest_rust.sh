#!/bin/sh
# Compiles the crates and their tests with the oldest Rust that Cargo.toml names, as a user may have it.
set -eu
cd "$(dirname "$0")/.."

version=$(sed -n 's/^rust-version = "\([0-9.]*\)"/\1/p' Cargo.toml)
rustup toolchain install "$version" --profile minimal
CARGO_TARGET_DIR=target/oldest-rust cargo "+$version" check --locked --workspace --all-targets
