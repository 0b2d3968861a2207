"""Named fluids, one file each."""
