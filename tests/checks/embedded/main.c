#include "sheen.h"

int main(void)
{
    return sheen_strerror(SHEEN_OK)[0] == '\0';
}
