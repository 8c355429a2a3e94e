# A room is a folder that is one library: every .cpp in it but main.cpp. Rooms are named as they are
# linked, on one line, so that CMakeLists.txt reads as the picture of who may look into whom.
# add_room(mesh/geometry mesh/core) makes the library mesh_geometry.
include(GoogleTest)

# Most of what a test or a file of the service costs to compile is the reading of the same few headers (GoogleTest,
# JSON, the messages): where this is on, they are read once for all of them. The preset `dev` does without, and sees
# that each file includes what it uses.
option(TETFARM_PRECOMPILED_HEADERS "Read the headers that many files include once" OFF)
set(TETFARM_OUTER_FLAGS "" CACHE STRING
    "How tests and the rooms around the work are compiled, beside what all files are compiled with")
# Compiled as everything is: what tests spend their time in.
set(rooms_that_work "^(base|mesh/.*|(coordinator|worker)/decisions)$")

# After the rooms: the rooms that are read with the precompiled headers.
function(precompile_headers)
  if(NOT TETFARM_PRECOMPILED_HEADERS)
    return()
  endif()
  file(WRITE ${PROJECT_BINARY_DIR}/common_headers.cpp "")
  add_library(common_headers OBJECT ${PROJECT_BINARY_DIR}/common_headers.cpp)
  target_link_libraries(common_headers PRIVATE proto GTest::gmock)
  target_include_directories(common_headers PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(common_headers PRIVATE ${TETFARM_OUTER_FLAGS})
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    # Else the times of the headers are in it, and no other clone finds in the cache what is compiled with it.
    target_compile_options(common_headers PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
  target_precompile_headers(common_headers PRIVATE
    <gtest/gtest.h> <gmock/gmock.h> <nlohmann/json.hpp> "${PROJECT_BINARY_DIR}/generated/proto/messages.pb.h"
    <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <memory> <optional> <random> <set>
    <sstream> <string> <thread> <variant> <vector>)
  get_property(rooms GLOBAL PROPERTY rooms_with_common_headers)
  foreach(room ${rooms})
    target_precompile_headers(${room} REUSE_FROM common_headers)
  endforeach()
endfunction()

function(room_target room out)
  string(REPLACE "/" "_" target ${room})
  set(${out} ${target} PARENT_SCOPE)
endfunction()

# So many files of a room read their headers once where this is on. The preset `dev` compiles each file by itself.
option(TETFARM_ROOMS_IN_BATCHES "Compile the files of a room together" OFF)
set(TETFARM_FILES_IN_BATCH 12 CACHE STRING "How many of them at once")

function(add_room room)
  room_target(${room} target)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${room}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(NOT sources)
    file(WRITE ${PROJECT_BINARY_DIR}/empty_${target}.cpp "")
    set(sources ${PROJECT_BINARY_DIR}/empty_${target}.cpp)
  endif()
  add_library(${target} STATIC ${sources})
  # What protoc makes is no file of a room.
  if(NOT room STREQUAL "proto")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${TETFARM_ROOMS_IN_BATCHES}
                          UNITY_BUILD_BATCH_SIZE ${TETFARM_FILES_IN_BATCH})
  endif()
  if(NOT room MATCHES ${rooms_that_work})
    target_compile_options(${target} PRIVATE ${TETFARM_OUTER_FLAGS})
    if(NOT room STREQUAL "proto")
      set_property(GLOBAL APPEND PROPERTY rooms_with_common_headers ${target})
    endif()
  endif()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  foreach(dependency ${ARGN})
    room_target(${dependency} library)
    target_link_libraries(${target} PUBLIC ${library})
  endforeach()
endfunction()

# Files that use a name of their own for what another file of their room calls by the same name.
function(compile_apart)
  list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# What every folder of formats may use; the check of the layers has the same list.
set(rooms_for_formats base mesh/core mesh/artifacts mesh/assemble mesh/formats mesh/formats/list)

# A folder of formats: add_format(su2) makes the room mesh/formats/su2, and puts the array su2_formats of
# mesh/formats/su2/su2_format.h in the list of all formats.
function(add_format folder)
  add_room(mesh/formats/${folder} ${rooms_for_formats} ${ARGN})
  set_property(GLOBAL APPEND PROPERTY folders_of_formats ${folder})
  set_property(GLOBAL PROPERTY rooms_for_${folder} ${ARGN})
endfunction()

# After the last of them: mesh/formats/list/all_formats.h, in the order of the lines.
function(write_list_of_formats)
  get_property(folders GLOBAL PROPERTY folders_of_formats)
  set(includes "")
  set(arrays "")
  foreach(folder ${folders})
    string(APPEND includes "#include \"mesh/formats/${folder}/${folder}_format.h\"\n")
    list(APPEND arrays "${folder}_formats")
  endforeach()
  list(JOIN arrays ", " arrays)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/all_formats.h.in
                 ${PROJECT_BINARY_DIR}/generated/mesh/formats/list/all_formats.h @ONLY)
  see_list_of_formats(mesh_formats_list)
endfunction()

function(see_list_of_formats target)
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated)
endfunction()

# Links all formats, or those that need none of some rooms: link_formats(TARGET [WITHOUT ROOM...]).
function(link_formats target)
  cmake_parse_arguments(PARSE_ARGV 1 given "" "" "WITHOUT")
  formats_without(rooms ${given_WITHOUT})
  see_list_of_formats(${target})
  foreach(room ${rooms})
    room_target(${room} library)
    target_link_libraries(${target} PUBLIC ${library})
  endforeach()
endfunction()

# Their rooms.
function(formats_without out)
  get_property(folders GLOBAL PROPERTY folders_of_formats)
  set(rooms "")
  foreach(folder ${folders})
    get_property(needed GLOBAL PROPERTY rooms_for_${folder})
    set(is_wanted TRUE)
    foreach(room ${ARGN})
      if(room IN_LIST needed)
        set(is_wanted FALSE)
      endif()
    endforeach()
    if(is_wanted)
      list(APPEND rooms mesh/formats/${folder})
    endif()
  endforeach()
  set(${out} ${rooms} PARENT_SCOPE)
endfunction()

# The tests of a room lie in tests/ROOM: *_test.cpp are fast, *_slow_test.cpp carry the label slow. Those of the
# rooms of single formats belong to mesh/formats.
# Each room has at most two programs: ROOM_test and ROOM_slow_test.
function(add_room_tests room)
  room_target(${room} target)
  set(pattern ${PROJECT_SOURCE_DIR}/tests/${room}/*_test.cpp)
  if(room STREQUAL "mesh/formats")
    list(APPEND pattern ${PROJECT_SOURCE_DIR}/tests/${room}/*/*_test.cpp)
  endif()
  file(GLOB all CONFIGURE_DEPENDS ${pattern})
  set(slow ${all})
  list(FILTER slow INCLUDE REGEX "_slow_test\\.cpp$")
  set(fast ${all})
  list(FILTER fast EXCLUDE REGEX "_slow_test\\.cpp$")
  if(fast)
    add_test_program(${target}_test "${fast}" "fast" ${target} ${ARGN})
  endif()
  if(slow)
    add_test_program(${target}_slow_test "${slow}" "slow" ${target} ${ARGN})
  endif()
endfunction()

option(TETFARM_TESTS_IN_BATCHES "Compile the files of tests of a room together" OFF)
set(TETFARM_TESTS_IN_BATCH 10 CACHE STRING "How many of them at once")

# The files that take the place of `sources`: made anew when one of these changes.
function(batch_tests program sources out)
  set(paths "")
  foreach(source ${sources})
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    list(APPEND paths ${source})
  endforeach()
  set(script ${PROJECT_SOURCE_DIR}/cmake/batch_tests.py)
  execute_process(COMMAND python3 ${script} ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/batches/${program}
                          ${TETFARM_TESTS_IN_BATCH} ${paths}
                  OUTPUT_VARIABLE batches COMMAND_ERROR_IS_FATAL ANY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${script} ${sources})
  set(${out} ${batches} PARENT_SCOPE)
endfunction()

function(add_test_program program sources label)
  if(TETFARM_TESTS_IN_BATCHES)
    batch_tests(${program} "${sources}" sources)
  endif()
  add_executable(${program} ${sources})
  target_link_libraries(${program} PRIVATE ${ARGN} GTest::gmock GTest::gtest_main)
  target_compile_options(${program} PRIVATE ${TETFARM_OUTER_FLAGS})
  if(TETFARM_PRECOMPILED_HEADERS)
    target_precompile_headers(${program} REUSE_FROM common_headers)
  endif()
  if(label STREQUAL "slow" AND NOT TETFARM_SLOW_TESTS)
    set_target_properties(${program} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  gtest_discover_tests(${program} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 TEST_PREFIX "${program}:"
                       PROPERTIES LABELS ${label}
                       # Keys of whoever runs the tests are no business of theirs.
                       ENVIRONMENT "XDG_CONFIG_HOME=${PROJECT_BINARY_DIR}/no_configuration" SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
endfunction()
