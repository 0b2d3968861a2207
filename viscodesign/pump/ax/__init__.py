"""The servos AX-12A and AX-18A, behind the contract: their state, limits, start and plunger."""
