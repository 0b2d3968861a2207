"""The scene: a validated spec in SI units."""
