# Qhull's reentrant library as the target Qhull::qhull_r: by its own CMake package, or, where it brings none, as Qhull
# 2015 of Ubuntu 20.04, by its header and library.
find_package(Qhull CONFIG QUIET)
if(NOT TARGET Qhull::qhull_r)
  find_path(Qhull_INCLUDE_DIR libqhull_r/qhull_ra.h)
  find_library(Qhull_LIBRARY qhull_r)
  mark_as_advanced(Qhull_INCLUDE_DIR Qhull_LIBRARY)
  if(Qhull_INCLUDE_DIR AND Qhull_LIBRARY)
    add_library(Qhull::qhull_r UNKNOWN IMPORTED)
    set_target_properties(Qhull::qhull_r PROPERTIES
      IMPORTED_LOCATION ${Qhull_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${Qhull_INCLUDE_DIR})
  endif()
endif()

if(TARGET Qhull::qhull_r)
  set(Qhull_target Qhull::qhull_r)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Qhull REQUIRED_VARS Qhull_target)
