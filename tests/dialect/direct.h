// The same smallest level.
#include "tests/dialect/transport.h"
