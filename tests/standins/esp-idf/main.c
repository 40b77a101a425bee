/*
 * main.c - stands for the code that calls app_main().
 */
#include "wire.h"

void app_main(void);

int main(void)
{
    app_main();
    wire_number('F', 0);
    return fflush(stdout) != 0;
}
