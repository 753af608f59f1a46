# The engine's own shaders; the files in include/ are only included.
file(GLOB engine_shaders CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/shaders/engine/*.glsl)
tyndall_shaders(tyndall_engine_shaders ${TYNDALL_BIN_DIR}/shaders ${engine_shaders})
add_dependencies(tyndall_render tyndall_engine_shaders)
