# SPDX-License-Identifier: MIT
# What `cmake --install` puts where, beside the rules in the folders of the commands, the driver and
# the QGIS plugin: the C++ library with its headers and packages, man pages, texts; and `uninstall`.
# Included last: it collects what the folders before it have made.
include(CMakePackageConfigHelpers)

set(QMESH_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/qmesh)

# ---- The library: all modules of common/ as one archive, target qmesh::qmesh ---------------------

get_property(all GLOBAL PROPERTY QMESH_MODULES)
get_property(links GLOBAL PROPERTY QMESH_LINKS)
set(modules "")
set(folders "")
foreach(module IN LISTS all)
  get_target_property(folder qmesh_${module} SOURCE_DIR)
  if(folder MATCHES "^${PROJECT_SOURCE_DIR}/common/(.*)") # not the driver
    list(APPEND modules ${module})
    list(APPEND folders ${CMAKE_MATCH_1})
  endif()
endforeach()
list(REMOVE_DUPLICATES links)
list(REMOVE_ITEM links nlohmann_json::nlohmann_json) # headers only, and not in ours
if(QMESH_WITH_CGAL)
  list(APPEND links mpfr gmp) # CGAL itself is headers only; its exact arithmetic is not
endif()

add_library(qmesh STATIC)
set_target_properties(qmesh PROPERTIES LINKER_LANGUAGE CXX)
foreach(module IN LISTS modules)
  target_sources(qmesh PRIVATE $<TARGET_OBJECTS:qmesh_${module}>)
  add_dependencies(qmesh qmesh_${module})
endforeach()
target_compile_features(qmesh INTERFACE cxx_std_17)
target_link_libraries(qmesh INTERFACE ${links})
install(TARGETS qmesh EXPORT qmeshTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT qmeshTargets NAMESPACE qmesh:: DESTINATION ${QMESH_PACKAGE_DIR})

# Headers below include/qmesh; inside the project they call each other "base/status.h", outside
# "qmesh/base/status.h", so that a stranger's own base/ is not in the way.
install(CODE "
  set(folders \"${folders}\")
  set(source \"${PROJECT_SOURCE_DIR}/common\")
  set(staging \"${PROJECT_BINARY_DIR}/installed-headers\")
  set(destination \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/qmesh\")
  include(\"${PROJECT_SOURCE_DIR}/cmake/InstallHeaders.cmake\")")

# ---- Packages: find_package(qmesh) and pkg-config --------------------------------------------------

file(RELATIVE_PATH QMESH_PC_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" QMESH_PC_PREFIX ${QMESH_PC_PREFIX})
set(QMESH_PC_LIBS "-pthread")
if(QMESH_WITH_CGAL)
  string(PREPEND QMESH_PC_LIBS "-lmpfr -lgmp ")
endif()
if(QMESH_WITHOUT_LIBDEFLATE)
  string(PREPEND QMESH_PC_LIBS "-lz ")
else()
  string(PREPEND QMESH_PC_LIBS "-ldeflate ")
endif()
configure_package_config_file(cmake/qmeshConfig.cmake.in qmeshConfig.cmake
                              INSTALL_DESTINATION ${QMESH_PACKAGE_DIR}
                              NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(qmeshConfigVersion.cmake COMPATIBILITY SameMinorVersion)
configure_file(cmake/qmesh.pc.in qmesh.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/qmeshConfig.cmake ${PROJECT_BINARY_DIR}/qmeshConfigVersion.cmake
              cmake/FindDeflateOrZlib.cmake
        DESTINATION ${QMESH_PACKAGE_DIR})
install(FILES ${PROJECT_BINARY_DIR}/qmesh.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# ---- Texts -------------------------------------------------------------------------------------------

install(FILES README.md LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
# Where the documentation was built. By code, because a rule for a folder installs its empty folders, too.
install(CODE "
  file(GLOB pages \"${PROJECT_BINARY_DIR}/docs/man/*.1\")
  if(pages)
    file(INSTALL \${pages} DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\")
  endif()")

# `cmake --install` may be given another prefix than the configured one.
install(CODE "file(WRITE \"${PROJECT_BINARY_DIR}/install_prefix.txt\" \"\${CMAKE_INSTALL_PREFIX}\")")
add_custom_target(uninstall
  COMMAND ${CMAKE_COMMAND} -D BUILD=${PROJECT_BINARY_DIR}
          -P ${PROJECT_SOURCE_DIR}/cmake/Uninstall.cmake
  VERBATIM)
