"""A robot on its legs: a rigid body, gas-filled actuators, and feet on the ground."""
