"""Sensors: gyroscopes in a body and films of it, and the motions fitted to what they saw."""
