"""What all figures and films share: style, and the body on its rim as a camera sees it."""
