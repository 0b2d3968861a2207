"""Linear algebra and Newton's method."""
