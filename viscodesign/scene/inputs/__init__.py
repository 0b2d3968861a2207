"""Input kinds, one file each; `base` defines what a kind must provide."""
