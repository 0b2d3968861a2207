"""The scene: what a spec says, validated, in SI."""
