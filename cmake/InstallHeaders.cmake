# SPDX-License-Identifier: MIT
# Run by `cmake --install`: the headers of common/FOLDER/ with includes as a user of the library
# sees them. Wants: folders, source, staging, destination (absolute, without DESTDIR).
list(JOIN folders "|" pattern)
foreach(folder IN LISTS folders)
  file(GLOB headers RELATIVE ${source} ${source}/${folder}/*.h)
  foreach(header IN LISTS headers)
    file(READ ${source}/${header} text)
    string(REGEX REPLACE "#include \"((${pattern})/)" "#include \"qmesh/\\1" text "${text}")
    set(old "")
    if(EXISTS ${staging}/${header})
      file(READ ${staging}/${header} old)
    endif()
    if(NOT text STREQUAL old)
      file(WRITE ${staging}/${header} "${text}")
    endif()
    file(INSTALL ${staging}/${header} DESTINATION ${destination}/${folder})
  endforeach()
endforeach()
