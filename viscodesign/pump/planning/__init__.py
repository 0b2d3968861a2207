"""What a pump must do, what it can do, and what to change."""
