"""Registers, packets and transactions of the AX servos (Dynamixel protocol 1.0)."""
