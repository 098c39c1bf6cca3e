# Settings every target of this package shares.

# cable_variation_configure(<target>): our warnings, and <cable_variation/room/file.h> on its include path.
function(cable_variation_configure target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  if(WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/src)
endfunction()
