"""Tables, files and pictures of a run; reads trajectories and nothing else."""
