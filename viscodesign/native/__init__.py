"""Native code without a compiler on the user's machine: small formulas and the loops around them.

`kernels` turns CasADi functions into machine code, kept in the user's cache folder; `tables` sums
kernels over the elements of a scene; `sparse_lu` solves with the matrix of a step; `march` takes
steps of Rodas5P. Everything may be called from several threads at once.
"""
