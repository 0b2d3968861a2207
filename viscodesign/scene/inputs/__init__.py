"""Input kinds, one file each; `base` says what a kind must offer."""
