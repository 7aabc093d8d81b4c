#!/bin/sh
# Prints a folder with Debian's newest Rust compiler, the sources of its standard library and a linker
# for WebAssembly. apt downloads them, and they are unpacked there; nothing is installed.
set -eu
cd "$(dirname "$0")/.."

folder=$PWD/target/debian-rust
if [ ! -e "$folder/complete" ]; then
    # The dependencies of a package whose names begin with a prefix.
    needs() { apt-cache depends "$1" | sed -n "s/^ *Depends: \($2[0-9.]*\)\$/\1/p" | head -n 1; }
    [ -n "$(needs rustc-web libstd-rust-web-dev)" ] || apt-get update -qq >&2
    library=$(needs libstd-rust-web-dev libstd-rust-web-)
    llvm=$(needs "$library" libllvm)
    if [ -z "$library" ] || [ -z "$llvm" ]; then
        echo "rimroll: Rust cannot compile to WebAssembly here; for Debian's own Rust: apt install libstd-rust-dev-wasm32 lld" >&2
        exit 1
    fi

    rm -rf "$folder"
    mkdir -p "$folder/packages"
    (
        cd "$folder/packages"
        apt-get -qq -o APT::Sandbox::User=root download rustc-web libstd-rust-web-dev "$library" rust-web-src \
            "$llvm" "lld-${llvm#libllvm}" >&2
        for package in *.deb; do dpkg -x "$package" ..; done
    )
    rm -r "$folder/packages"
    ln -sf "wasm-ld-${llvm#libllvm}" "$folder/usr/bin/wasm-ld"
    ln -sf "lld-${llvm#libllvm}" "$folder/usr/bin/rust-lld"
    touch "$folder/complete"
fi
echo "$folder"
