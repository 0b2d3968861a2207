"""From a scene to a trajectory with its error stated."""
