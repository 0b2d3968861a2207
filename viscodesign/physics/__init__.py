"""Formulas with their symbols, units, validity and sources; numbers in, numbers out."""
