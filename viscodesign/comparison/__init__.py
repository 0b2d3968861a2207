"""Motions compared: runs, specs and measured tables, and the figures of the paper."""
