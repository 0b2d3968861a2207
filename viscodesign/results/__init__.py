"""Plain data of results."""
