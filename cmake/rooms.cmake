# A room is a folder that is one library: every .cpp in it but main.cpp. Rooms are named as they are
# linked, on one line, so that CMakeLists.txt reads as the picture of who may look into whom.
# add_room(mesh/geometry mesh/core) makes the library mesh_geometry.
include(GoogleTest)

# Half of what a test costs to compile is the reading of GoogleTest: where this is on, it is read once for all
# tests. GCC then takes inlined code of system headers for ours and warns of it, so the preset `dev`, whose
# warnings are errors, does without; it also sees that each test includes what it uses.
option(TETFARM_PRECOMPILED_TESTS "Read GoogleTest once for all tests" OFF)
set(TETFARM_TEST_FLAGS "" CACHE STRING "How tests are compiled, beside what all files are compiled with")
if(TETFARM_PRECOMPILED_TESTS)
  file(WRITE ${PROJECT_BINARY_DIR}/test_headers.cpp "")
  add_library(test_headers OBJECT ${PROJECT_BINARY_DIR}/test_headers.cpp)
  target_link_libraries(test_headers PRIVATE GTest::gmock)
  target_precompile_headers(test_headers PRIVATE <gtest/gtest.h> <gmock/gmock.h>)
  set(test_flags -fpch-preprocess ${TETFARM_TEST_FLAGS})
  target_compile_options(test_headers PRIVATE ${test_flags})
else()
  set(test_flags ${TETFARM_TEST_FLAGS})
endif()

function(room_target room out)
  string(REPLACE "/" "_" target ${room})
  set(${out} ${target} PARENT_SCOPE)
endfunction()

# Twelve files of a room of the mesh read their headers once where this is on. The preset `dev` compiles each file
# by itself.
option(TETFARM_ROOMS_IN_BATCHES "Compile the files of a room together" OFF)

function(add_room room)
  room_target(${room} target)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${room}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main\\.cpp$")
  if(NOT sources)
    file(WRITE ${PROJECT_BINARY_DIR}/empty_${target}.cpp "")
    set(sources ${PROJECT_BINARY_DIR}/empty_${target}.cpp)
  endif()
  add_library(${target} STATIC ${sources})
  if(room MATCHES "^(base|mesh/.*|store|pool)$")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${TETFARM_ROOMS_IN_BATCHES} UNITY_BUILD_BATCH_SIZE 12)
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

function(add_test_program program sources label)
  add_executable(${program} ${sources})
  target_link_libraries(${program} PRIVATE ${ARGN} GTest::gmock GTest::gtest_main)
  target_compile_options(${program} PRIVATE ${test_flags})
  if(TETFARM_PRECOMPILED_TESTS)
    target_precompile_headers(${program} REUSE_FROM test_headers)
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
