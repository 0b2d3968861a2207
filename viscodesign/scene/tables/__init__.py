"""Tables of numbers in files: how they are written, what their columns are, noise in them."""
