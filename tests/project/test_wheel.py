"""The wheel is complete: it contains the page of the lab."""

import os
import subprocess
import sys
import zipfile
from importlib import resources
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = resources.files("rimroll") / "page"


@pytest.mark.skipif(not (PAGE / "index.html").is_file(), reason="the page is not built: make web")
def test_the_wheel_ships_the_page_with_its_core_and_licences(tmp_path):
    # Compiled as by tools/build_extension.sh, so that nothing is compiled again.
    folder = Path(sys.prefix)
    environment = {name: text for name, text in os.environ.items() if name != "CONDA_PREFIX"}
    environment |= {
        "VIRTUAL_ENV": str(folder),
        "PATH": f"{folder / 'bin'}{os.pathsep}{os.environ['PATH']}",
    }
    subprocess.run(
        ["maturin", "build", "--quiet", "--release", "--out", tmp_path],
        cwd=ROOT,
        env=environment,
        check=True,
        capture_output=True,
    )
    with zipfile.ZipFile(next(tmp_path.glob("*.whl"))) as wheel:
        names = wheel.namelist()
        assert wheel.read("rimroll/page/index.html") == (PAGE / "index.html").read_bytes()
        assert wheel.read("rimroll/page/alone.js") == (PAGE / "alone.js").read_bytes()
        assert b"three" in wheel.read("rimroll/page/licences.txt")
    assert any(name.startswith("rimroll/page/") and name.endswith(".wasm") for name in names)
