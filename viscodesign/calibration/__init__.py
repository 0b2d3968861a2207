"""Numbers of a spec from measurements: what they are, how surely, and what to measure next."""
