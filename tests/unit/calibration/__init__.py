"""Fits and what they are made of."""
