"""From a solution to its motion, balances, terminations and warnings."""
