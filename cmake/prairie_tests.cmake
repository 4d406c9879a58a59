prairie_precompiled(prairie_precompiled_tests ${PROJECT_SOURCE_DIR}/cmake/precompiled.h <gtest/gtest.h>)
target_link_libraries(prairie_precompiled_tests PRIVATE GTest::gtest)

# prairie_tests(NAME SOURCES … DEPENDS … [TIMEOUT SECONDS]): the tests of the room NAME, such as render/gl, as one
# program, prairie_render_gl_tests. Each becomes a test ROOM.Suite.Name, ROOM the top-level folder; suites
# named …LongTest are labelled long. Their helpers, tests/PATH, may be among the sources from anywhere.
function(prairie_tests name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;DEPENDS" ${ARGN})
  string(REPLACE / _ room ${name})
  string(REGEX REPLACE "/.*" "" top ${name})
  set(target prairie_${room}_tests)
  list(TRANSFORM ARG_SOURCES REPLACE "^tests/" "${PROJECT_SOURCE_DIR}/tests/")
  add_executable(${target} ${ARG_SOURCES})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${target} PRIVATE ${prairie_definitions})
  target_precompile_headers(${target} REUSE_FROM prairie_precompiled_tests)
  target_link_libraries(${target} PRIVATE GTest::gtest_main prairie_flags ${ARG_DEPENDS})
  target_compile_definitions(${target} PRIVATE
    PRAIRIE_SOURCES="${PROJECT_SOURCE_DIR}" PRAIRIE_TEST_SHADERS="${PROJECT_SOURCE_DIR}/shaders")
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  gtest_discover_tests(${target} TEST_PREFIX ${top}. TEST_FILTER "-*LongTest.*" DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT ${ARG_TIMEOUT})
  gtest_discover_tests(${target} TEST_PREFIX ${top}. TEST_FILTER "*LongTest.*" DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 1500 LABELS long)
endfunction()
