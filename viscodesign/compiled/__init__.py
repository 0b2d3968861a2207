"""A scene as a function of its numbers: what may be free, and all that follows."""
