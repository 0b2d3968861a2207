"""Quick estimates of a scene: its quantities, and a linear motion made of them."""
