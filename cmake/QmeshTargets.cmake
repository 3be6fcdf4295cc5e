# SPDX-License-Identifier: MIT
# How every target of the project is made.

# Flags every target shares. Contraction is off so that the same input gives the
# same bytes on machines with and without fused multiply-add (promise P3).
function(qmesh_configure target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor
                         -ffp-contract=off)
  if(QMESH_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(QMESH_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${QMESH_SANITIZE}
                           -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${QMESH_SANITIZE})
  endif()
endfunction()

# qmesh_module(NAME SOURCES a.cpp ... DEPENDS base ... [LINKS Lib::Lib ...])
# A folder of common/ as a library. It sees only the folders it names, so an
# include that points up does not link.
function(qmesh_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;LINKS" ${ARGN})
  add_library(qmesh_${name} STATIC ${ARG_SOURCES})
  qmesh_configure(qmesh_${name})
  target_include_directories(qmesh_${name} PUBLIC ${PROJECT_SOURCE_DIR}/common)
  foreach(dep IN LISTS ARG_DEPENDS)
    target_link_libraries(qmesh_${name} PUBLIC qmesh_${dep})
  endforeach()
  target_link_libraries(qmesh_${name} PUBLIC ${ARG_LINKS})
  # For the installed library (QmeshInstall.cmake), which holds all modules.
  set_property(GLOBAL APPEND PROPERTY QMESH_MODULES ${name})
  set_property(GLOBAL APPEND PROPERTY QMESH_LINKS ${ARG_LINKS})
endfunction()

# qmesh_test(NAME SOURCES test_a.cpp ... DEPENDS module ... [SHARDS n])
# SHARDS: the program runs n times, each time with its share of the test cases, so that they take several cores.
function(qmesh_test name)
  cmake_parse_arguments(ARG "" "SHARDS" "SOURCES;DEPENDS" ${ARGN})
  add_executable(test_${name} ${ARG_SOURCES})
  qmesh_configure(test_${name})
  target_link_libraries(test_${name} PRIVATE GTest::gtest_main)
  foreach(dep IN LISTS ARG_DEPENDS)
    target_link_libraries(test_${name} PRIVATE qmesh_${dep})
  endforeach()
  if(NOT ARG_SHARDS)
    add_test(NAME ${name} COMMAND test_${name})
    return()
  endif()
  math(EXPR last "${ARG_SHARDS} - 1")
  foreach(shard RANGE ${last})
    add_test(NAME ${name}_${shard} COMMAND test_${name})
    set_tests_properties(${name}_${shard} PROPERTIES
                         ENVIRONMENT "GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${shard}")
  endforeach()
endfunction()
