"""What rhegma-plot, rhegma-report and rhegma-study are made of."""
