# Every package of the build, all of them from Debian 12.
find_package(Eigen3 3.4 CONFIG REQUIRED)
find_package(NLopt CONFIG REQUIRED PATHS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/nlopt_cxx NO_DEFAULT_PATH)
find_package(fcl CONFIG REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(CLI11 CONFIG REQUIRED)
find_package(yaml-cpp CONFIG REQUIRED)
find_package(fmt CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(TBB CONFIG REQUIRED)
find_package(Qhull CONFIG REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)

# OMPL's own variables name Boost libraries that it does not need.
find_library(OMPL_LIBRARY ompl REQUIRED)
find_path(OMPL_INCLUDE_DIR ompl/base/SpaceInformation.h PATH_SUFFIXES ompl-1.5 REQUIRED)
add_library(ompl_system INTERFACE)
target_include_directories(ompl_system SYSTEM INTERFACE ${OMPL_INCLUDE_DIR})
target_link_libraries(ompl_system INTERFACE ${OMPL_LIBRARY} Eigen3::Eigen)
