# Finds Ipopt (COIN-OR) and defines Ipopt::Ipopt; its headers are included as <coin/...>, after HAVE_CSTDDEF is defined.
find_path(IPOPT_INCLUDE_DIR coin/IpIpoptApplication.hpp)
find_library(IPOPT_LIBRARY ipopt)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Ipopt REQUIRED_VARS IPOPT_LIBRARY IPOPT_INCLUDE_DIR)
if(Ipopt_FOUND AND NOT TARGET Ipopt::Ipopt)
  add_library(Ipopt::Ipopt UNKNOWN IMPORTED)
  set_target_properties(Ipopt::Ipopt PROPERTIES
    IMPORTED_LOCATION ${IPOPT_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${IPOPT_INCLUDE_DIR})
endif()
mark_as_advanced(IPOPT_INCLUDE_DIR IPOPT_LIBRARY)
