"""From a solution to what is told of it: motion, balances, events, validity."""
