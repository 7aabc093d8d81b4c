#!/bin/sh
# Builds the documentation site into out/docs, with the lab, the reproduced paper and the crate's
# documentation inside. Warnings are errors. `make docs` runs it when these have been built. If PYODIDE
# names a full distribution of Pyodide, a folder or an https address, the notebooks run in the page.
set -eu
cd "$(dirname "$0")/.."

# In a folder of its own: `make lint` documents private items, too, in that of the other builds.
RUSTDOCFLAGS="-D warnings" cargo doc --quiet --package rimroll --no-deps --target-dir out/docs-work/rust
# Sphinx would not warn again of a page that has not changed, so after a failure it starts afresh.
.venv/bin/sphinx-build --quiet --nitpicky --fail-on-warning --keep-going \
    --doctree-dir out/docs-work/doctrees docs out/docs || {
    rm -rf out/docs-work
    exit 1
}
rm -rf out/docs/lab out/docs/paper out/docs/reference/rust
cp -R python/rimroll/page out/docs/lab
cp -R out/paper out/docs/paper
cp -R out/docs-work/rust/doc out/docs/reference/rust
rm -rf out/docs/notebooks
if [ -n "${PYODIDE:-}" ]; then
    .venv/bin/python tools/build_wheels.py pyodide
    .venv/bin/python tools/build_notebooks.py "$PYODIDE" dist/*-pyemscripten_*_wasm32.whl out/docs/notebooks
fi
touch out/docs/.nojekyll  # GitHub Pages would leave out folders that begin with _
.venv/bin/python tools/check_site.py out/docs
echo "The site is out/docs/index.html."
