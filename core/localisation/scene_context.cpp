#include "core/localisation/scene_context.h"
