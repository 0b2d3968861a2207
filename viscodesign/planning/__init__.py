"""From the pressures that a scene wants to what its pump has to do, and can do."""
