"""Many simulations of a scene and one answer: accuracy, sweeps, sensitivities, bands."""
