#include "ui/speech/speech_queue.h"
