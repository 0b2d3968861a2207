"""Inverse design: the numbers, the input and the graph that make the tip follow a path."""
