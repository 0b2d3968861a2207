"""Where pressures are measured."""
