"""Effects: terms of the balances, each with a weight that says when it matters."""
