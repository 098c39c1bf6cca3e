"""Builds the rigid surroundings of the example scenes from small closed solids. Metres throughout."""
