# tyndall_room(NAME SOURCES... [ARROWS room...] [LINK lib...])
# One static library per room. A room's public headers live in <dir>/include/<room>/; only rooms named in
# ARROWS (and what they in turn export) are on its include path, so a wrong arrow does not compile.
function(tyndall_room name)
  cmake_parse_arguments(ARG "" "" "SOURCES;ARROWS;LINK;PRIVATE_LINK" ${ARGN})
  add_library(tyndall_${name} STATIC ${ARG_SOURCES})
  target_include_directories(tyndall_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/include)
  foreach(arrow IN LISTS ARG_ARROWS)
    target_link_libraries(tyndall_${name} PUBLIC tyndall_${arrow})
  endforeach()
  target_link_libraries(tyndall_${name} PUBLIC ${ARG_LINK} PRIVATE tyndall_flags ${ARG_PRIVATE_LINK})
endfunction()
