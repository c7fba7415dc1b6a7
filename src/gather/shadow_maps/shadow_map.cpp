// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/shadow_map.h"
