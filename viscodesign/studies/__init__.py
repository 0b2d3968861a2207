"""Many simulations of one scene, and one answer."""
