"""The table of wrong scenes: what is done to a right one, and what a user must read."""

from wrong_bodies import BODIES, DOMAIN, LOADS, MATERIALS, TIME
from wrong_cells import ACCURACY, ADAPTIVITY, MASS
from wrong_cracks import CRACKS, NOT_IN_3D, PROPAGATION
from wrong_heat import COMBUSTION, HEAT
from wrong_lists import MISSING, NAMES, REFERENCES, SEVERAL, TYPES

TABLE = NAMES + MISSING + TYPES + MATERIALS + BODIES + DOMAIN + TIME + LOADS + CRACKS + ACCURACY
TABLE += COMBUSTION + HEAT + NOT_IN_3D + MASS + ADAPTIVITY + PROPAGATION + REFERENCES + SEVERAL
