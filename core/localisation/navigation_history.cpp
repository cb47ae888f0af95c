#include "core/localisation/navigation_history.h"
