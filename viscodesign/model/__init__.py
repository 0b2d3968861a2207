"""The balances of the coupled model, written symbolically; plain numbers in, no YAML."""
