"""``python -m rimroll.cli``: the command line without its script."""

import sys

from rimroll.cli import main

sys.exit(main())
