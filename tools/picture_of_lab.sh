#!/bin/sh
# Takes the picture of the lab in the README, docs/images/lab.png, from the page that make web builds.
set -eu
cd "$(dirname "$0")/.."

tools/test_page.sh --project drawn picture -t "just after the near-collision"
.venv/bin/python - <<'END'
from PIL import Image

picture = Image.open("out/lab/readme.png").convert("RGB")
small = picture.resize((1100, round(1100 * picture.height / picture.width)), Image.Resampling.LANCZOS)
# So few colours are enough, if those of small things are among them.
small = small.quantize(256, Image.Quantize.MAXCOVERAGE, kmeans=4, dither=Image.Dither.NONE)
small.save("docs/images/lab.png", optimize=True)
END
echo "wrote docs/images/lab.png"
