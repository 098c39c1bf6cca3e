#pragma once

namespace cable_variation {

/// Of this package, as package.xml has it: "0.1.0".
const char* packageVersion();

}  // namespace cable_variation
