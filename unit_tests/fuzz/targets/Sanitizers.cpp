/// What the sanitizers are to know of HDF5. The readers need neither MPI nor Kokkos.

/// It asks whether there is so much memory as a file says and takes no for an answer.
extern "C" const char* __asan_default_options() { return "allocator_may_return_null=1"; }

/// What it loses then is not ours.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5\n"; }
