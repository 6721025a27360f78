# For Trilinos: this repository adds no libraries of others to its list. The package finds its own, HDF5, zlib, JSON,
# muParser, UDUNITS-2, and PNG and TIFF where they are there (cmake/RhegmaFindLibraries.cmake).
tribits_repository_define_tpls()
