/*
 * inject.c - makes chosen ioctls of a program fail before they reach the kernel (LD_PRELOAD).
 *
 *   INJECT="EIO@7"            the seventh fails
 *   INJECT="EINTR@7,EIO@27"   the seventh and the 27th fail
 *   INJECT="EINTR@1+2"        the first and then every second one fails
 *   INJECT="SHORT@1+1"        none fails, but of every SPI transfer only the first half is made
 *   INJECT_LOG=FILE           at the end, FILE holds the number of ioctls, the number of the last one that was made to
 *                             fail (0: none), and the bytes of the longest SPI transfer
 */
#include <dlfcn.h>
#include <errno.h>
#include <linux/spi/spidev.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct fault {
    int error;              /* 0: SHORT */
    unsigned long at, step; /* step 0: once */
};

static struct fault faults[4];
static unsigned fault_count;
static unsigned long calls, last, longest;

__attribute__((constructor)) static void read_plan(void)
{
    const char *text = getenv("INJECT");
    char name[8];
    int used;

    for (; text && *text && fault_count < 4; text += used + (text[used] == ',')) {
        struct fault *fault = &faults[fault_count];

        fault->step = 0;
        if (sscanf(text, "%7[A-Z]@%lu%n+%lu%n", name, &fault->at, &used, &fault->step, &used) < 2) {
            fprintf(stderr, "inject: INJECT=%s is not understood\n", text);
            _Exit(99);
        }
        fault->error = strcmp(name, "EINTR") == 0 ? EINTR : strcmp(name, "SHORT") == 0 ? 0 : EIO;
        fault_count++;
    }
}

__attribute__((destructor)) static void write_log(void)
{
    const char *path = getenv("INJECT_LOG");
    FILE *file = path ? fopen(path, "w") : NULL;

    if (file) {
        fprintf(file, "%lu %lu %lu\n", calls, last, longest);
        fclose(file);
    }
}

/* A controller that stops halfway: the kernel is asked for half the transfer and reports what it has sent. */
static void halve(unsigned long request, struct spi_ioc_transfer *transfer)
{
    if (request == SPI_IOC_MESSAGE(1) && transfer->len > 1)
        transfer->len /= 2;
}

int ioctl(int fd, unsigned long request, ...)
{
    static int (*next)(int, unsigned long, ...);
    va_list values;
    void *value;

    va_start(values, request);
    value = va_arg(values, void *);
    va_end(values);
    if (!next)
        next = (int (*)(int, unsigned long, ...))dlsym(RTLD_NEXT, "ioctl");
    if (request == SPI_IOC_MESSAGE(1) && ((struct spi_ioc_transfer *)value)->len > longest)
        longest = ((struct spi_ioc_transfer *)value)->len;
    calls++;
    for (unsigned i = 0; i < fault_count; i++) {
        const struct fault *fault = &faults[i];

        if (calls == fault->at || (fault->step && calls > fault->at && (calls - fault->at) % fault->step == 0)) {
            last = calls;
            if (fault->error == 0) {
                halve(request, value);
                continue;
            }
            errno = fault->error;
            return -1;
        }
    }
    return next(fd, request, value);
}
