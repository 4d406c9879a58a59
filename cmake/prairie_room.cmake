# prairie_room(NAME SOURCES … DEPENDS … PRIVATE_DEPENDS …): one static library per folder, with the flags on
# which bit-equal results between compilers, optimisation levels and the shaders rest (docs/design.md, D1).
# NAME is the folder's, such as render/gl; the target is prairie_render_gl, its alias prairie::render_gl.
add_library(prairie_flags INTERFACE)
target_compile_options(prairie_flags INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Werror=double-promotion
  # g++ 12 warns of copies between overlapping strings where there are none (GCC bug 105329).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  -ffp-contract=off -fno-math-errno -fno-trapping-math
  $<$<BOOL:${PRAIRIE_WERROR}>:-Werror>)
if(PRAIRIE_SANITIZE)
  target_compile_options(prairie_flags INTERFACE -fsanitize=${PRAIRIE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(prairie_flags INTERFACE -fsanitize=${PRAIRIE_SANITIZE})
endif()
set_property(GLOBAL PROPERTY PRAIRIE_ROOMS "")

function(prairie_room name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  string(REPLACE / _ room ${name})
  set(target prairie_${room})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(prairie::${room} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${room} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/prairie>)
  target_link_libraries(${target}
    PUBLIC ${ARG_DEPENDS}
    PRIVATE $<BUILD_INTERFACE:prairie_flags> ${ARG_PRIVATE_DEPENDS})
  set_property(GLOBAL APPEND PROPERTY PRAIRIE_ROOMS ${name})
endfunction()
