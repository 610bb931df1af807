# Finds SLIP_LU (SuiteSparse) and defines SlipLu::sliplu, with what it needs.
find_path(SLIPLU_INCLUDE_DIR SLIP_LU.h PATH_SUFFIXES suitesparse)
find_library(SLIPLU_LIBRARY sliplu)
find_library(SUITESPARSECONFIG_LIBRARY suitesparseconfig)
find_library(MPFR_LIBRARY mpfr)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SlipLu
  REQUIRED_VARS SLIPLU_LIBRARY SUITESPARSECONFIG_LIBRARY MPFR_LIBRARY SLIPLU_INCLUDE_DIR)
if(SlipLu_FOUND AND NOT TARGET SlipLu::sliplu)
  add_library(SlipLu::sliplu UNKNOWN IMPORTED)
  set_target_properties(SlipLu::sliplu PROPERTIES
    IMPORTED_LOCATION ${SLIPLU_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${SLIPLU_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "${SUITESPARSECONFIG_LIBRARY};${MPFR_LIBRARY};GMP::gmp")
endif()
mark_as_advanced(SLIPLU_INCLUDE_DIR SLIPLU_LIBRARY SUITESPARSECONFIG_LIBRARY MPFR_LIBRARY)
