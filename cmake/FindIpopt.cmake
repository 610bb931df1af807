# Finds Ipopt: IPOPT_INCLUDE_DIR, IPOPT_LIBRARY. Its headers need HAVE_CSTDDEF, as Debian's pkg-config file says.
find_path(IPOPT_INCLUDE_DIR IpIpoptApplication.hpp PATH_SUFFIXES coin coin-or)
find_library(IPOPT_LIBRARY ipopt)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Ipopt REQUIRED_VARS IPOPT_LIBRARY IPOPT_INCLUDE_DIR)
mark_as_advanced(IPOPT_INCLUDE_DIR IPOPT_LIBRARY)
