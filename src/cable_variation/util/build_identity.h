#pragma once

#include <string>

namespace cable_variation {

/// Which build of this library this is: the package's version and the linker's identifier of the library, as
/// "0.1.0 (build 5f3c...)"; programs of other sources, compilers or options have another. Without an
/// identifier the version alone.
std::string buildIdentity();

/// What of this machine may change the last bits of a calculation: the processor's vector instructions that
/// this library, and the system's, choose their code by, and the system's C library.
std::string machineIdentity();

}  // namespace cable_variation
