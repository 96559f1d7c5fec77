#include "shaders/light.h"
