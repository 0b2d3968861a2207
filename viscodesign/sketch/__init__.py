"""Quick sketches of a motion: what a term would change at the tip, without solving."""
