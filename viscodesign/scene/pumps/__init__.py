"""Sections `pump:` of a spec, one file for each kind of pump; `base` has what all share."""
