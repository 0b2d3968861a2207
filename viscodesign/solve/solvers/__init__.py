"""Ways through time, one file each."""
