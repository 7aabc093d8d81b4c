"""Many falls at once, and maps of them."""
