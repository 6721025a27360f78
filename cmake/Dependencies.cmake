# For Trilinos: the packages that Rhegma uses, as in RhegmaFindTrilinos.cmake.
tribits_package_define_dependencies(
  LIB_REQUIRED_PACKAGES  Kokkos  Teuchos  Tpetra  Belos  Zoltan2Core
  )
