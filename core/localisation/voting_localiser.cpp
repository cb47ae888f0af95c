#include "core/localisation/voting_localiser.h"
