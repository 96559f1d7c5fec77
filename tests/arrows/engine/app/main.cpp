#include "baker/baker.hpp"
#include "engine/gpu/device.hpp"
#include <boost/any.hpp> // forbidden: not one of the project's third parties
#include <CLI/CLI.hpp>
