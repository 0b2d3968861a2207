"""Solvers: they know equations and numbers, nothing of effects or specs."""
