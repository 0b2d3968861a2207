"""The pump: from a wanted pressure to a plunger's motion, played on a real device."""
