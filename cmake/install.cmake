# cmake --install: the program with its manual, and the mesh rooms as a library for other programs
# (examples/library): find_package(tetfarm), or pkg-config tetfarm.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

formats_without(formats mesh/formats/hdf5)
set(library_rooms mesh/library mesh/decompose mesh/planar mesh/graph mesh/volume mesh/recovery mesh/filling mesh/cosmetics mesh/spacing
    mesh/inspect mesh/shapes mesh/geometry
    mesh/formats/surfaces ${formats} mesh/formats mesh/assemble mesh/artifacts mesh/job_file mesh/formats/list mesh/core base)
set(archives "")
foreach(room ${library_rooms})
  room_target(${room} target)
  set_target_properties(${target} PROPERTIES OUTPUT_NAME tetfarm_${target})
  target_include_directories(${target} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/tetfarm>)
  install(TARGETS ${target} EXPORT tetfarm ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tetfarm/${room}/..
          FILES_MATCHING PATTERN "*.h")
  string(APPEND archives " -ltetfarm_${target}")
endforeach()

# The program with its manual and what makes shells complete its commands, which it prints itself:
# cmake --install build/release --component program leaves out the library.
install(TARGETS tetfarm RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(CODE "set(tetfarm_program \"$<TARGET_FILE:tetfarm>\")
set(tetfarm_made \"${PROJECT_BINARY_DIR}/told_by_program\")
set(tetfarm_manual \"${CMAKE_INSTALL_MANDIR}\")
set(tetfarm_data \"${CMAKE_INSTALL_DATADIR}\")" COMPONENT program)
install(SCRIPT ${PROJECT_SOURCE_DIR}/cmake/install_manual.cmake COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/deploy/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/deploy COMPONENT program
        PATTERN Containerfile EXCLUDE)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/tetfarm)
install(EXPORT tetfarm NAMESPACE tetfarm:: FILE tetfarm-targets.cmake DESTINATION ${package_folder})
write_basic_package_version_file(tetfarm-config-version.cmake COMPATIBILITY SameMinorVersion)
configure_file(${PROJECT_SOURCE_DIR}/cmake/tetfarm.pc.in tetfarm.pc @ONLY)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/tetfarm-config.cmake ${PROJECT_BINARY_DIR}/tetfarm-config-version.cmake
        DESTINATION ${package_folder})
install(FILES ${PROJECT_BINARY_DIR}/tetfarm.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
