# tyndall_shaders(TARGET OUTPUT_DIR SOURCES...)
# SOURCES are <name>.<vert|frag|comp|geom>.glsl.
# Compiles each GLSL source to SPIR-V with glslangValidator (with a dependency file, so that a changed include
# rebuilds it) into OUTPUT_DIR/<file name>.spv, and writes beside it <file name>.spv.json, which names the source and the include
# directories so that a running program can compile the shader again.
set(TYNDALL_SHADER_INCLUDES ${CMAKE_SOURCE_DIR}/shaders)
function(tyndall_shaders target output_dir)
  set(outputs)
  foreach(source IN LISTS ARGN)
    get_filename_component(source ${source} ABSOLUTE)
    get_filename_component(name ${source} NAME)
    string(REGEX REPLACE "\\.glsl$" "" stem ${name})
    string(REGEX MATCH "(vert|frag|comp|geom)$" stage ${stem})
    if(NOT stage)
      message(FATAL_ERROR "${source}: a shader's name ends in .vert.glsl, .frag.glsl, .comp.glsl or .geom.glsl")
    endif()
    set(spv ${output_dir}/${stem}.spv)
    set(includes ${TYNDALL_SHADER_INCLUDES} ${CMAKE_CURRENT_SOURCE_DIR})
    set(flags)
    foreach(dir IN LISTS includes)
      list(APPEND flags -I${dir})
    endforeach()
    add_custom_command(OUTPUT ${spv}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${output_dir}
      COMMAND Vulkan::glslangValidator -V --target-env vulkan1.3 --quiet -S ${stage} ${flags}
              --depfile ${spv}.d -o ${spv} ${source}
      DEPENDS ${source} DEPFILE ${spv}.d VERBATIM
      COMMENT "GLSL ${stem}")
    list(JOIN includes "\", \"" joined)
    file(GENERATE OUTPUT ${spv}.json CONTENT "{ \"source\": \"${source}\", \"stage\": \"${stage}\", \"includes\": [\"${joined}\"] }\n")
    list(APPEND outputs ${spv})
  endforeach()
  add_custom_target(${target} ALL DEPENDS ${outputs})
endfunction()
