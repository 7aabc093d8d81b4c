"""Tables of text, files that appear when they are complete, and what datasets record."""
