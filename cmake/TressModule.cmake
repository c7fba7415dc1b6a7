# tress_module(NAME dependency...): the static library tress_NAME, alias tress::NAME, of all sources below this folder.
function(tress_module name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_library(tress_${name} STATIC ${sources})
  add_library(tress::${name} ALIAS tress_${name})
  set_target_properties(tress_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(tress_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:include/tress>)
  target_compile_features(tress_${name} PUBLIC cxx_std_20)
  target_link_libraries(tress_${name} PUBLIC ${ARGN})
endfunction()
