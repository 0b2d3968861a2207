"""Fluids known by name, one file each."""
