# The pages of the dashboard as a part of the program: npm builds the folder web/ into a few files, which the program
# then has in it. Without npm, or where this is off, the program has a small page that says so, and the API all the same.
option(TETFARM_DASHBOARD "Build the pages of `tetfarm dashboard` (npm) into the program" ON)

# Has the room define built_in_web_files() of dashboard/web_pages.h.
function(embed_web_pages room)
  set(web ${PROJECT_SOURCE_DIR}/web)
  set(pages ${PROJECT_BINARY_DIR}/web_pages)
  set(source ${PROJECT_BINARY_DIR}/generated/dashboard/web_files.cpp)
  room_target(${room} target)
  if(TETFARM_DASHBOARD)
    find_program(NPM npm)
  endif()
  if(TETFARM_DASHBOARD AND NPM AND EXISTS ${web}/package.json)
    file(GLOB_RECURSE inputs CONFIGURE_DEPENDS ${web}/src/* ${web}/public/*)
    file(GLOB settings CONFIGURE_DEPENDS ${web}/*.json ${web}/*.js ${web}/*.mjs ${web}/*.ts ${web}/*.html)
    add_custom_command(
      OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -Dweb=${web} -Dwork=${PROJECT_BINARY_DIR}/web -Dpages=${pages} -Dnpm=${NPM}
              -Dsource=${source} -P ${PROJECT_SOURCE_DIR}/cmake/build_web_pages.cmake
      DEPENDS ${inputs} ${settings} ${PROJECT_SOURCE_DIR}/cmake/build_web_pages.cmake
              ${PROJECT_SOURCE_DIR}/cmake/write_web_files.cmake
      COMMENT "Building the pages of the dashboard"
      VERBATIM)
  else()
    if(TETFARM_DASHBOARD AND NOT NPM)
      message(STATUS "npm is not here: `tetfarm dashboard` gets its API and no pages")
    endif()
    set(pages "")
    include(${PROJECT_SOURCE_DIR}/cmake/write_web_files.cmake)
  endif()
  target_sources(${target} PRIVATE ${source})
  # What is made is no file of the room: it has its own flags, and is compiled by itself.
  set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
endfunction()
