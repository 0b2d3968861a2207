"""Profiles as poses of an ArbotiX board."""
