#include "core/building/geopackage.h"
