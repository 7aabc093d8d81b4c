"""The parts of the census: random draws, engines, comparison and explanations."""
