"""The family of servos AX-12A and AX-18A: their state, limits and start, behind the contract."""
