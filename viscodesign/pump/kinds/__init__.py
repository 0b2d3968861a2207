"""Kinds of pump, one file each: how one is planned, reached, moved, read and kept safe."""
