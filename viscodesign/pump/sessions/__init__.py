"""Whole sessions with a pump: connect, stream, upload, record, rehearse, calibrate, stop.

Each is a function of `viscodesign.pump`. None prints: what a user should read or agree to goes
through the callables `tell` and `confirm`.
"""
