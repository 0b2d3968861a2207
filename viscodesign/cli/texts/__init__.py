"""How results are laid out as text."""
