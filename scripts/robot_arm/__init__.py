"""A six-axis arm: its parts, its joints, and where they put its hand."""
