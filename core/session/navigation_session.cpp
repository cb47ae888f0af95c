#include "core/session/navigation_session.h"
