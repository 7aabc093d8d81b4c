"""A whole motion fitted to the record of a gyroscope: start, law of contact, sensor."""
