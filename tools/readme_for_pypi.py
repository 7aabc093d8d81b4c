"""Makes the links of README.md absolute, in place: PyPI shows the text without the files beside it.

The address of the repository is that of pyproject.toml; the files are those of the version's tag.
"""

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]


def absolute(text: str, repository: str, tag: str) -> str:
    """The text with links to files of the tree as addresses: pictures raw, others as pages."""
    raw = repository.replace("https://github.com/", "https://raw.githubusercontent.com/")

    def replaced(link: re.Match[str]) -> str:
        base = f"{raw}/{tag}" if link["picture"] else f"{repository}/blob/{tag}"
        return f"{link['picture']}[{link['text']}]({base}/{link['file']})"

    pattern = r"(?P<picture>!?)\[(?P<text>[^]]+)\]\((?!https?:|#|mailto:)(?P<file>[^)]+)\)"
    return re.sub(pattern, replaced, text)


if __name__ == "__main__":
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    cargo = tomllib.loads((ROOT / "Cargo.toml").read_text("utf-8"))
    tag = f"v{cargo['workspace']['package']['version']}"
    readme = ROOT / "README.md"
    text = absolute(readme.read_text("utf-8"), project["urls"]["Repository"], tag)
    readme.write_text(text, "utf-8")
