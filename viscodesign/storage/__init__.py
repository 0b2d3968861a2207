"""Arrays on disk, and files that are complete or absent."""
