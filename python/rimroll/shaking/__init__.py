"""Many motions on tables that move, and the statistics that engineers draw from them."""
