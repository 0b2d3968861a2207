"""From YAML to a scene and back."""
