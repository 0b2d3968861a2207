"""Servos, boards and sensors that are only computed, and speak the real bytes."""
