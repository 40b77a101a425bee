#include "picture.c"
