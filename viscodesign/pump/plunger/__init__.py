"""The plunger of a syringe: what a plan asks of it, and of the servo that moves it."""
