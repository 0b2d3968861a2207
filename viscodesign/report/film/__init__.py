"""Films of a run: GIF and WebP, and MP4 where ffmpeg is found."""
