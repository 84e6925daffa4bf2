# Copyright (c) 2026 The Spline_constraints_d authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# merge_sources(OUTPUT SOURCE...): writes one source with the #include lines of all sources, each once, and their rest, each in a namespace of its own: source_NAME for NAME.cpp.
# What the sources include is compiled once then, also the templates and inline functions that they use. The sources define no macros that others of them use.
function(merge_sources output)
  set(includes "")
  set(rests "")
  foreach(source IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(STRINGS ${source} lines REGEX "^#include ")
    list(APPEND includes ${lines})
    file(READ ${source} text)
    string(REGEX REPLACE "#include [^\n]*" "" text "${text}")
    cmake_path(GET source STEM name)
    string(APPEND rests "namespace source_${name} {\n#line 1 \"${source}\"\n${text}\n}\n")
  endforeach()
  list(REMOVE_DUPLICATES includes)
  list(JOIN includes "\n" includes)
  file(WRITE ${output}.new "${includes}\n${rests}")
  file(COPY_FILE ${output}.new ${output} ONLY_IF_DIFFERENT)   # the time stamp tells what to build
endfunction()
