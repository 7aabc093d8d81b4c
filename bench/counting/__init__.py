"""The parts of the census: what is drawn, computed, compared and explained."""
