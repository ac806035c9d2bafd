# Every package of the build; versions are the least that will do, where a package lets ask for one.
find_package(Eigen3 3.4 CONFIG REQUIRED)
find_package(fcl 0.7 CONFIG REQUIRED)
find_package(HDF5 1.10 REQUIRED COMPONENTS C)
find_package(CLI11 2.1 CONFIG REQUIRED)
find_package(yaml-cpp 0.7 CONFIG REQUIRED)
find_package(fmt 9 CONFIG REQUIRED)
find_package(nlohmann_json 3.11 CONFIG REQUIRED)
find_package(TBB 2021 CONFIG REQUIRED)
find_package(Qhull 8 CONFIG REQUIRED)
find_package(assimp 5.2 CONFIG REQUIRED)
find_package(urdfdom CONFIG REQUIRED)
find_package(console_bridge 1 CONFIG REQUIRED)
find_package(tinyxml2 CONFIG REQUIRED)
find_package(OpenSSL 3 REQUIRED COMPONENTS Crypto)
find_package(SQLite3 3.40 REQUIRED)
find_package(ZLIB REQUIRED)

# Debian keeps NLopt with its C++ algorithms beside the plain one, under a name of its own.
find_package(NLopt 2.7 CONFIG QUIET PATHS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/nlopt_cxx NO_DEFAULT_PATH)
if(NOT NLopt_FOUND)
  find_package(NLopt 2.7 CONFIG REQUIRED)
endif()
if(NOT TARGET NLopt::nlopt_cxx)
  add_library(NLopt::nlopt_cxx ALIAS NLopt::nlopt)
endif()
# It defines _FILE_OFFSET_BITS for whoever links it, which says nothing on 64 bits, but no precompiled
# header fits then.
set_target_properties(tinyxml2::tinyxml2 PROPERTIES INTERFACE_COMPILE_DEFINITIONS "")
# Before version 0.8 the target has no namespace.
if(NOT TARGET yaml-cpp::yaml-cpp)
  add_library(yaml-cpp::yaml-cpp ALIAS yaml-cpp)
endif()

# OMPL's own variables name Boost libraries that it does not need; its folder is named by version.
find_library(OMPL_LIBRARY ompl REQUIRED)
file(GLOB ompl_folders /usr/local/include/ompl-* /usr/include/ompl-*)
find_path(OMPL_INCLUDE_DIR ompl/base/SpaceInformation.h PATHS ${ompl_folders} REQUIRED)
file(STRINGS ${OMPL_INCLUDE_DIR}/ompl/config.h ompl_numbers REGEX "define OMPL_(MAJOR|MINOR|PATCH)_VERSION +[0-9]+")
list(TRANSFORM ompl_numbers REPLACE "[^0-9]" "")
list(JOIN ompl_numbers "." OMPL_VERSION)
add_library(ompl_system INTERFACE)
target_include_directories(ompl_system SYSTEM INTERFACE ${OMPL_INCLUDE_DIR})
target_link_libraries(ompl_system INTERFACE ${OMPL_LIBRARY} Eigen3::Eigen)

# MuJoCo is for `morphe simulate` alone: without it the program is built, and says so there. Its own
# config asks for OpenGL and Qhull, which the library does not need.
find_library(MUJOCO_LIBRARY mujoco)
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h)
add_library(mujoco_system INTERFACE)
if(MORPHE_PHYSICS AND MUJOCO_LIBRARY AND MUJOCO_INCLUDE_DIR)
  set(morphe_has_physics ON)
  target_include_directories(mujoco_system SYSTEM INTERFACE ${MUJOCO_INCLUDE_DIR})
  target_link_libraries(mujoco_system INTERFACE ${MUJOCO_LIBRARY})
else()
  set(morphe_has_physics OFF)
  message(STATUS "without MuJoCo (libmujoco-dev): morphe simulate will only say so")
endif()

# What rounding and searches depend on, as every plans.h5 says it.
set(morphe_built_with "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
foreach(package Eigen3 assimp fcl HDF5 NLopt OMPL Qhull TBB)
  string(APPEND morphe_built_with ", ${package} ${${package}_VERSION}")
endforeach()
