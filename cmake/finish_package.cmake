# Run by cpack when everything is installed and nothing is packed yet: what Debian wants of a package beside that. The
# manual and the changelogs are packed without a name or time in them, so that the same files give the same bytes.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()

function(pack_files)
  foreach(file ${ARGN})
    execute_process(COMMAND gzip -9 -n -f ${file} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endfunction()

# Of the package NAME, whose files lie in the folder `part`; what is told of it lies in cmake/debian/FILES.
function(add_papers part name files)
  set(documents ${part}/usr/share/doc/${name})
  file(MAKE_DIRECTORY ${documents} ${part}/usr/share/lintian/overrides)
  file(COPY_FILE ${CPACK_TETFARM_DEBIAN_FILES}/copyright ${documents}/copyright)
  file(COPY_FILE ${CPACK_TETFARM_DEBIAN_FILES}/changelog ${documents}/changelog.Debian)
  pack_files(${documents}/changelog.Debian)
  file(COPY_FILE ${CPACK_TETFARM_DEBIAN_FILES}/${files}/lintian-overrides ${part}/usr/share/lintian/overrides/${name})
endfunction()

set(program ${CPACK_TEMPORARY_DIRECTORY}/tetfarm)
set(documents ${program}/usr/share/doc/tetfarm)
execute_process(COMMAND strip --remove-section=.comment --remove-section=.note ${program}/usr/bin/tetfarm
                COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE pages ${program}/usr/share/man/*.[1-8])
pack_files(${pages})
# The licences are in copyright.
file(REMOVE ${documents}/LICENSE ${documents}/examples/LICENSE-Apache-2.0)
file(RENAME ${documents}/CHANGELOG.md ${documents}/changelog)
pack_files(${documents}/changelog)
add_papers(${program} tetfarm program)
add_papers(${CPACK_TEMPORARY_DIRECTORY}/coordinator tetfarm-coordinator coordinator)
