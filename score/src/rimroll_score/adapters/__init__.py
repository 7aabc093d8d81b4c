"""Adapters, one file for each engine."""
