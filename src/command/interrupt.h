#pragma once

namespace cable_variation_command {

/// From now on SIGINT (Ctrl-C) and SIGTERM do not end the program but are counted; a second one ends it as
/// usual.
void countInterrupts();

/// Whether there was one.
bool interrupted();

}  // namespace cable_variation_command
