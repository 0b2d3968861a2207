"""Values as they are written: one number and one unit, and the slips around them."""
