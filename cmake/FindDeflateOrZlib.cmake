# SPDX-License-Identifier: MIT
# Target qmesh::deflate: libdeflate where there is one (three times faster), else zlib.
find_path(QMESH_LIBDEFLATE_INCLUDE libdeflate.h)
find_library(QMESH_LIBDEFLATE_LIBRARY deflate)
add_library(qmesh::deflate INTERFACE IMPORTED)
if(QMESH_LIBDEFLATE_INCLUDE AND QMESH_LIBDEFLATE_LIBRARY AND NOT QMESH_WITH_ZLIB)
  target_include_directories(qmesh::deflate INTERFACE ${QMESH_LIBDEFLATE_INCLUDE})
  target_link_libraries(qmesh::deflate INTERFACE ${QMESH_LIBDEFLATE_LIBRARY})
  target_compile_definitions(qmesh::deflate INTERFACE QMESH_HAVE_LIBDEFLATE=1)
else()
  find_package(ZLIB REQUIRED)
  target_link_libraries(qmesh::deflate INTERFACE ZLIB::ZLIB)
endif()
