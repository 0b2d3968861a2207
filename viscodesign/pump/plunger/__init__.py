"""The plunger of a syringe: what a plan asks of it, whatever drives it."""
