"""Formulas with symbols, units, validity and sources; functions of numbers only."""
