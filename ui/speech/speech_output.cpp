#include "ui/speech/speech_output.h"
