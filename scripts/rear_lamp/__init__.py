"""The parts of the rear lamps, built with the solids of the engine bay."""
