"""Set-points in real time, and the rules that keep a pump safe."""
