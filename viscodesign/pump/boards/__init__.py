"""Boards that command the servos, one file each."""
