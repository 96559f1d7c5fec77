#include "engine/core/log.hpp" // forbidden: a higher row
