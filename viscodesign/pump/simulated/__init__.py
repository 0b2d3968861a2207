"""Simulated servos, firmware and syringes, down to the bytes."""
