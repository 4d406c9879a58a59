# prairie_room(NAME SOURCES … DEPENDS … PRIVATE_DEPENDS …): one static library per folder, with the flags on
# which bit-equal results between compilers, optimisation levels and the shaders rest (docs/design.md, D1).
# NAME is the folder's, such as render/gl; the target is prairie_render_gl, its alias prairie::render_gl.
add_library(prairie_flags INTERFACE)
target_compile_options(prairie_flags INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion -Werror=double-promotion
  # g++ 12 warns of copies between strings that overlap, or are longer than memory, where there are none (GCC
  # bugs 105329, 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow>
  -ffp-contract=off -fno-math-errno -fno-trapping-math
  $<$<BOOL:${PRAIRIE_WERROR}>:-Werror>)
target_link_libraries(prairie_flags INTERFACE fmt::fmt)  # among the precompiled headers
if(PRAIRIE_SANITIZE)
  # What the address sanitizer sees by itself would only be compiled for longer.
  target_compile_options(prairie_flags INTERFACE
    -fsanitize=${PRAIRIE_SANITIZE} -fno-sanitize=null,object-size,vptr -fno-omit-frame-pointer)
  target_link_options(prairie_flags INTERFACE -fsanitize=${PRAIRIE_SANITIZE})
endif()
set_property(GLOBAL PROPERTY PRAIRIE_ROOMS "")

# Plain x, y, z members, no unions: optimisers keep such vectors in registers. Everywhere, or types would differ.
set(prairie_definitions GLM_FORCE_XYZW_ONLY)

# prairie_precompiled(TARGET HEADERS …): headers parsed once for all targets that are compiled alike.
function(prairie_precompiled target)
  file(WRITE ${PROJECT_BINARY_DIR}/${target}.cpp "")
  add_library(${target} OBJECT ${PROJECT_BINARY_DIR}/${target}.cpp)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_definitions(${target} PRIVATE ${prairie_definitions})
  target_link_libraries(${target} PRIVATE prairie_flags)
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()
prairie_precompiled(prairie_precompiled_rooms ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
set_target_properties(prairie_precompiled_rooms PROPERTIES POSITION_INDEPENDENT_CODE ON)

function(prairie_room name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  string(REPLACE / _ room ${name})
  set(target prairie_${room})
  add_library(${target} STATIC ${ARG_SOURCES})
  add_library(prairie::${room} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${room} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_definitions(${target} PUBLIC ${prairie_definitions})
  target_precompile_headers(${target} REUSE_FROM prairie_precompiled_rooms)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/prairie>)
  target_link_libraries(${target}
    PUBLIC ${ARG_DEPENDS}
    PRIVATE $<BUILD_INTERFACE:prairie_flags> ${ARG_PRIVATE_DEPENDS})
  set_property(GLOBAL APPEND PROPERTY PRAIRIE_ROOMS ${name})
endfunction()
