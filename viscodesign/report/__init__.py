"""Tables, pictures, films and the page of a run; reads trajectories and their specs."""
