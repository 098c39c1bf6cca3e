# Assimp as the target assimp::assimp, by its header and library: what Ubuntu 20.04's pkg-config file and CMake package
# say of them is wrong.
find_path(assimp_INCLUDE_DIR assimp/Importer.hpp)
find_library(assimp_LIBRARY assimp)
mark_as_advanced(assimp_INCLUDE_DIR assimp_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(assimp REQUIRED_VARS assimp_LIBRARY assimp_INCLUDE_DIR)
if(assimp_FOUND AND NOT TARGET assimp::assimp)
  add_library(assimp::assimp UNKNOWN IMPORTED)
  set_target_properties(assimp::assimp PROPERTIES
    IMPORTED_LOCATION ${assimp_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${assimp_INCLUDE_DIR})
endif()
