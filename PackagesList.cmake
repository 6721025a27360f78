# For Trilinos, which takes this repository as an extra one (docs/how-to/build-within-trilinos.md): it holds one package, in its
# root.
tribits_repository_define_packages(
  Rhegma  .  ST
  )
