# What an installation holds: the program, its shaders, the libraries with their headers, and what
# find_package(prairie) needs; nothing of it refers to the sources.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/prairie)

get_property(rooms GLOBAL PROPERTY PRAIRIE_ROOMS)
list(FILTER rooms EXCLUDE REGEX "^(app|bench)")  # parts of the program alone
list(TRANSFORM rooms PREPEND prairie_ OUTPUT_VARIABLE room_targets)
list(TRANSFORM room_targets REPLACE / _)
install(TARGETS prairie RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${room_targets} prairie_kernels EXPORT prairieTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/prairie)
install(EXPORT prairieTargets NAMESPACE prairie:: DESTINATION ${package_dir})

# Headers include one another as "ROOM/name.h"; the kernels and layouts are part of them.
list(FILTER rooms EXCLUDE REGEX /)
foreach(room IN LISTS rooms)
  install(DIRECTORY ${room}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/prairie/${room}
    FILES_MATCHING PATTERN "*.h")
endforeach()
foreach(folder shared kernels)
  install(DIRECTORY shaders/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/prairie/shaders)
endforeach()
install(DIRECTORY shaders DESTINATION ${CMAKE_INSTALL_DATADIR}/prairie
  PATTERN CMakeLists.txt EXCLUDE PATTERN README.md EXCLUDE)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/prairie)

install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR})
foreach(text README.md CHANGELOG.md)
  install(FILES ${text} DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
endforeach()

configure_package_config_file(cmake/prairieConfig.cmake.in ${PROJECT_BINARY_DIR}/prairieConfig.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/prairieConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/FindOpenImageIO.cmake ${PROJECT_BINARY_DIR}/prairieConfig.cmake
  ${PROJECT_BINARY_DIR}/prairieConfigVersion.cmake DESTINATION ${package_dir})
