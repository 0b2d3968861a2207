"""Arrays on disk, and files that are whole or absent."""
