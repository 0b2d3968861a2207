"""Serial lines and ports, clocks, and the log of bytes."""
