"""How pictures are laid out: style, labels, snapshots, thinning."""
