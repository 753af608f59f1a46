# tyndall_plugin(NAME [SAMPLE] SOURCES file... [SHADERS file...] [LINK target...])
# A plugin: bin/plugins/NAME.so and its shaders in bin/plugins/NAME/ (with SAMPLE: bin/sample_plugins/, which no program
# loads unasked). Target: tyndall_plugin_NAME. Only the ABI, shaders/ and GLM are on the include path.
# -fno-gnu-unique: unique symbols would pin the library in memory, so that a rebuilt one could not replace it.
function(tyndall_plugin name)
  cmake_parse_arguments(ARG "SAMPLE" "" "SOURCES;SHADERS;LINK" ${ARGN})
  set(folder ${TYNDALL_BIN_DIR}/plugins)
  if(ARG_SAMPLE)
    set(folder ${TYNDALL_BIN_DIR}/sample_plugins)
  endif()
  set(target tyndall_plugin_${name})
  add_library(${target} MODULE ${ARG_SOURCES})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} PREFIX "" SUFFIX ".so"
    LIBRARY_OUTPUT_DIRECTORY ${folder} C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_SOURCE_DIR}/shaders)
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fno-gnu-unique>)
  target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL)
  target_link_libraries(${target} PRIVATE tyndall_abi tyndall_flags glm::glm ${ARG_LINK})
  if(ARG_SHADERS)
    tyndall_shaders(${target}_shaders ${folder}/${name} ${ARG_SHADERS})
    add_dependencies(${target} ${target}_shaders)
  endif()
endfunction()
