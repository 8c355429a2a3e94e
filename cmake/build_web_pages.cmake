# While it is built: has npm build a copy of the folder `web` in the folder `work`, into the folder `pages`, and writes
# `source` with what came of it. Nothing is written in the source tree. node_modules stays between builds as long as
# package-lock.json does.
function(run_npm what)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env TETFARM_WEB_OUT=${pages} ${npm} ${ARGN}
                  WORKING_DIRECTORY ${work} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    list(JOIN ARGN " " words)
    message(FATAL_ERROR "${said}\nThe pages of the dashboard could not be ${what} (npm ${words} in ${work}). "
      "Without a network, or without them: configure with -DTETFARM_DASHBOARD=OFF.")
  endif()
endfunction()

file(MAKE_DIRECTORY ${work})
file(GLOB old RELATIVE ${work} ${work}/*)
list(REMOVE_ITEM old node_modules installed.lock)
foreach(name ${old})
  file(REMOVE_RECURSE ${work}/${name})
endforeach()
file(COPY ${web}/ DESTINATION ${work} PATTERN node_modules EXCLUDE PATTERN dist EXCLUDE)
file(READ ${web}/package-lock.json wanted)
set(installed "")
if(EXISTS ${work}/installed.lock AND EXISTS ${work}/node_modules)
  file(READ ${work}/installed.lock installed)
endif()
if(NOT wanted STREQUAL installed)
  file(REMOVE_RECURSE ${work}/installed.lock ${work}/node_modules)  # an npm that was killed leaves what npm cannot remove
  run_npm("installed" ci --no-audit --no-fund --fetch-retries=5)
  file(COPY_FILE ${web}/package-lock.json ${work}/installed.lock)
endif()
file(REMOVE_RECURSE ${pages})
run_npm("built" run build)
if(NOT EXISTS ${pages}/index.html)
  message(FATAL_ERROR "npm run build left no index.html in ${pages}")
endif()
include(${CMAKE_CURRENT_LIST_DIR}/write_web_files.cmake)
