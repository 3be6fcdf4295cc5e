# SPDX-License-Identifier: MIT
# cmake -D BUILD=FOLDER -P Uninstall.cmake: removes what the last install from that build folder wrote,
# the folders below the prefix that are empty then, and the byte code Python put beside our files.
# Honours DESTDIR.
cmake_minimum_required(VERSION 3.22)
set(manifest "${BUILD}/install_manifest.txt")
if(NOT EXISTS "${manifest}" OR NOT EXISTS "${BUILD}/install_prefix.txt")
  message(FATAL_ERROR "Nothing was installed from ${BUILD}: there is no ${manifest}.")
endif()
file(READ "${BUILD}/install_prefix.txt" prefix)
string(PREPEND prefix "$ENV{DESTDIR}")

# Removes a folder below the prefix and those above it, as long as they are empty. Below /usr and
# /usr/local the folders that everybody shares stay.
function(remove_if_empty folder)
  file(GLOB content LIST_DIRECTORIES TRUE "${folder}/*" "${folder}/.*")
  list(FILTER content EXCLUDE REGEX "/\\.\\.?$")
  string(FIND "${folder}" "${prefix}/" below)
  if(content OR NOT IS_DIRECTORY "${folder}" OR NOT below EQUAL 0)
    return()
  endif()
  if(prefix MATCHES "^(/usr|/usr/local)$" AND
     folder MATCHES "^${prefix}/(bin|lib|include|share|lib/[^/]+|share/(doc|man|man/man1|qgis))$")
    return()
  endif()
  file(REMOVE_RECURSE "${folder}")
  get_filename_component(parent "${folder}" DIRECTORY)
  remove_if_empty("${parent}")
endfunction()

file(STRINGS "${manifest}" files)
set(folders "")
foreach(file IN LISTS files)
  string(PREPEND file "$ENV{DESTDIR}")
  message(STATUS "Removing ${file}")
  file(REMOVE "${file}")
  get_filename_component(folder "${file}" DIRECTORY)
  list(APPEND folders "${folder}")
  if(file MATCHES "\\.py$")
    file(REMOVE_RECURSE "${folder}/__pycache__")
  endif()
endforeach()
list(REMOVE_DUPLICATES folders)
foreach(folder IN LISTS folders)
  remove_if_empty("${folder}")
endforeach()
file(REMOVE "${manifest}" "${BUILD}/install_prefix.txt")
