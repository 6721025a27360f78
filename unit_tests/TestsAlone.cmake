# Files of unit tests that use the same local names as others of their folder: a strict build, which compiles files in
# groups, compiles these alone. It fails with "redefinition" or "ambiguous" where one is missing here.
set(RHEGMA_TESTS_ALONE
  packages/combustion/tstFaceHeat packages/combustion/tstGasExchange packages/contact/tstFaceContact
  packages/cracks/tstBrokenCell packages/cracks/tstCorrectedBrokenCell packages/cracks/tstFrontSmoothing
  packages/cracks/tstLocking packages/energy_release/tstCrackClosure packages/energy_release/tstErrorEstimate
  packages/energy_release/tstFrontLines packages/energy_release/tstFronts3D packages/energy_release/tstInclinedCracks
  packages/energy_release/tstNegativeRelease packages/energy_release/tstPressedCracks
  packages/energy_release/tstSpringFronts packages/mass_matrix/tstVibration
  packages/propagation/tstJunctionGas packages/propagation/tstJunctions packages/propagation/tstPennyGrowth
  packages/registry/tstOwnSections packages/thermal/tstCellExpansion packages/thermal/tstConduction
  packages/thermal/tstConductionIntegrator packages/thermal/tstCoupling packages/thermal/tstCrackConduction
  packages/thermal/tstJudgeTemperatures packages/thermal/tstMeetingMaterials src/output/tstRunLock
  src/parallel/tstOnRanks src/scene/tstMistakes src/scene/tstOverrides src/scene/tstTimeFunction
  src/surface/tstSurfaceMesh src/transfer/tstShearStrain src/transfer/tstTreeStencil)
