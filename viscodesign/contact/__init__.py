"""Unilateral contact with Coulomb friction, by complementarity; numbers only."""
