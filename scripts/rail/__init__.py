"""The parts of the rail, built with the solids of the engine bay."""
