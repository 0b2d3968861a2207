"""How a motion depends on the numbers of its scene: many designs, and what each number does."""
