"""The model as sums of equal local terms: one small kernel for each kind, and index arrays."""
