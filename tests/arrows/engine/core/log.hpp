#include "shaders/light.h"
#include <string>
