"""Whole sessions with a pump: connect, stream, upload, record, calibrate, stop."""
