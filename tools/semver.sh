#!/bin/sh
# Compares the public interface of the crate with that of the last release: cargo-semver-checks knows
# which changes ask for which version. Before the first release there is nothing to compare with.
# The search begins at the parent: the commit of a release carries the tag of that release itself.
set -eu
cd "$(dirname "$0")/.."

if last=$(git describe --tags --abbrev=0 --match 'v[0-9]*' HEAD^ 2>/dev/null); then
    echo "The interface is compared with that of $last."
    exec cargo semver-checks --package rimroll --baseline-rev "$last"
fi
echo "There is no tag of a release yet: nothing to compare the interface with."
