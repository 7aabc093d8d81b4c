#!/bin/sh
# Prints a folder with Debian's Python for arm64, and an emulator that runs it on another processor. apt
# downloads them, and they are unpacked there; nothing is installed.
set -eu
cd "$(dirname "$0")/.."

folder=$PWD/target/debian-arm64
if [ ! -e "$folder/complete" ]; then
    rm -rf "$folder"
    mkdir -p "$folder/apt/lists/partial" "$folder/packages/archives/partial"
    touch "$folder/apt/status" # of a machine where nothing is installed
    arm64() {
        apt-get -qq -o APT::Sandbox::User=root -o APT::Architecture=arm64 -o APT::Architectures=arm64 \
            -o Dir::State="$folder/apt" -o Dir::State::status="$folder/apt/status" \
            -o Dir::Cache="$folder/packages" "$@" >&2
    }
    arm64 update
    arm64 install --download-only --no-install-recommends --yes python3 libstdc++6
    (
        cd "$folder/packages/archives"
        apt-get -qq -o APT::Sandbox::User=root download qemu-user-static >&2
        for package in *.deb; do dpkg -x "$package" "$folder"; done
    )
    rm -r "$folder/apt" "$folder/packages"
    touch "$folder/complete"
fi
echo "$folder"
