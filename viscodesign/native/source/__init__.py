"""Loops over plain arrays, in the part of Python that numba can compile.

`docs/make_loops.py` makes ``loops.ll`` of them, which is what runs; as plain Python they are the
twin that tests compare it with. Arrays are flat and never overlap. Nothing is checked here:
`tables`, `sparse_lu` and `march` do that. Names of functions are unique among these files.
"""
