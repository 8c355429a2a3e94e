# cpack in a build folder: the packages tetfarm (the program with its manual, completions, Python module, documents and
# examples) and tetfarm-coordinator (its services) for Debian, and a tarball of the first that may be unpacked anywhere.
# ./dev package makes all of them.
set(CPACK_PACKAGE_NAME tetfarm)
set(CPACK_PACKAGE_VENDOR "The Tetfarm authors")
set(CPACK_PACKAGE_CONTACT "The Tetfarm authors <tetfarm@packages.invalid>" CACHE STRING "Maintainer of the packages")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "mesh generator for tetrahedra, on one machine or on a farm")
set(CPACK_PACKAGE_FILE_NAME ${PROJECT_NAME}-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program python documents coordinator)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package_of_generator.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/finish_package.cmake)
set(CPACK_THREADS 0)
set(CPACK_TETFARM_DEBIAN_FILES ${PROJECT_SOURCE_DIR}/cmake/debian)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(package_scripts ${PROJECT_SOURCE_DIR}/cmake/debian)
set(CPACK_DEBIAN_TETFARM_PACKAGE_NAME tetfarm)
set(CPACK_DEBIAN_TETFARM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TETFARM_PACKAGE_SUGGESTS "python3, python3-numpy, python3-h5py, tetfarm-coordinator, paraview")
set(CPACK_DEBIAN_TETFARM_PACKAGE_CONTROL_EXTRA ${package_scripts}/program/postinst ${package_scripts}/program/prerm)
set(CPACK_DEBIAN_TETFARM_DESCRIPTION
"Tetfarm makes tetrahedral meshes of what closed surfaces enclose, or of the
space round them, with boundary layers of prisms where a job asks for them. It
cuts the domain into sub-domains and meshes these as tasks of their own, on one
machine or on a farm of workers that may fail at any time; the mesh is the same
to the bit however many there are.
.
With the program come its manual, completions for shells, a module for Python,
documents and examples.")

set(CPACK_DEBIAN_COORDINATOR_PACKAGE_NAME tetfarm-coordinator)
set(CPACK_DEBIAN_COORDINATOR_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_COORDINATOR_PACKAGE_DEPENDS "tetfarm (>= ${PROJECT_VERSION}), systemd | systemd-standalone-sysusers, systemd | systemd-standalone-tmpfiles")
set(CPACK_DEBIAN_COORDINATOR_PACKAGE_CONTROL_EXTRA
    ${package_scripts}/coordinator/postinst ${package_scripts}/coordinator/prerm ${package_scripts}/coordinator/postrm
    ${package_scripts}/coordinator/conffiles)
set(CPACK_DEBIAN_COORDINATOR_DESCRIPTION
"Tetfarm makes tetrahedral meshes of what closed surfaces enclose, or of the
space round them, on one machine or on a farm of workers.
.
This package has the services of systemd for a farm, which are the coordinator,
workers on this machine, and pools of workers from a batch system, with their
user and their settings in /etc/tetfarm. None is started by itself.")

# What of it the program does not have itself.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/tetfarm DESTINATION lib/python3/dist-packages COMPONENT python
        FILES_MATCHING PATTERN "*.py" PATTERN py.typed PATTERN __pycache__ EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents PATTERN site EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents
        PATTERN __pycache__ EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/LICENSE
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)

set(services ${PROJECT_SOURCE_DIR}/deploy/systemd)
install(FILES ${services}/tetfarm-coordinator.service ${services}/tetfarm-worker@.service
        ${services}/tetfarm-pool@.service DESTINATION lib/systemd/system COMPONENT coordinator EXCLUDE_FROM_ALL)
install(FILES ${services}/tetfarm.sysusers DESTINATION lib/sysusers.d RENAME tetfarm.conf COMPONENT coordinator EXCLUDE_FROM_ALL)
install(FILES ${services}/tetfarm.tmpfiles DESTINATION lib/tmpfiles.d RENAME tetfarm.conf COMPONENT coordinator EXCLUDE_FROM_ALL)
install(FILES ${services}/coordinator.conf ${services}/worker.conf ${services}/pool.conf DESTINATION /etc/tetfarm
        COMPONENT coordinator EXCLUDE_FROM_ALL)

include(CPack)
cpack_add_component_group(tetfarm)
cpack_add_component(program GROUP tetfarm)
cpack_add_component(python GROUP tetfarm)
cpack_add_component(documents GROUP tetfarm)
cpack_add_component(coordinator)
