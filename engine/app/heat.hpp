// A map of errors as a picture.
#pragma once
#include "engine/core/image.hpp"

namespace afterglow
{
// Of one channel, 0..1: from black over violet and orange to pale yellow; brighter is worse, also in grey.
Image8 heat(const Image& map);
}
