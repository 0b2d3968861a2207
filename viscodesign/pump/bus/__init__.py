"""Bytes on a serial line: packets, transactions, ports."""
