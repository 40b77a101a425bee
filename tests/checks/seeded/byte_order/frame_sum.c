#include <stdint.h>
#include <stdio.h>

int main(void)
{
    const uint16_t pixel = 0xf800;

    printf("%02x\n", *(const uint8_t *)&pixel);
    return 0;
}
