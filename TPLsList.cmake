# For Trilinos: this repository adds no libraries of others to its list. The package finds its own, HDF5, zlib, JSON,
# muParser and UDUNITS-2 (cmake/RhegmaFindLibraries.cmake).
tribits_repository_define_tpls()
