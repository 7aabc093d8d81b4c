#!/bin/sh
# Tests the lab: its modules, and the built page in a headless Chromium. Without Chromium, the tests
# of the page are skipped with a message; with CI=true this is an error. Arguments go to vitest.
set -eu
cd "$(dirname "$0")/.."

chromium() {
    for name in "${RIMROLL_CHROMIUM:-}" chromium-headless-shell chromium chromium-browser google-chrome \
        "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome"; do
        path=$(command -v "$name") && [ -f "$path" ] && [ -x "$path" ] && echo "$path" && return
    done
    return 1
}

if RIMROLL_CHROMIUM=$(chromium); then
    export RIMROLL_CHROMIUM
    exec tools/node.sh vitest run "$@"
fi
get_it="apt install chromium-headless-shell fonts-dejavu-core, or RIMROLL_CHROMIUM=/path/to/chromium"
if [ "${CI:-}" = true ]; then
    echo "rimroll: no Chromium to test the page in; $get_it" >&2
    exit 1
fi
tools/node.sh vitest run --project modules "$@"
echo "rimroll: the page was not tested in a browser, as no Chromium was found; to do so: $get_it" >&2
