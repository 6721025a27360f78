"""What rhegma-plot and rhegma-study are made of."""
