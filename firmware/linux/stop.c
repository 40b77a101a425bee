/*
 * stop.c - see stop.h.
 */
#include "stop.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t asked;

static void ask(int signal)
{
    (void)signal;
    asked = 1;
}

void stop_watch(void)
{
    /* SA_RESETHAND: a second signal has its default effect, if the bus hangs. No SA_RESTART, so that sleeps end. */
    struct sigaction action = {.sa_handler = ask, .sa_flags = SA_RESETHAND}, before;

    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    if (sigaction(SIGHUP, NULL, &before) == 0 && before.sa_handler != SIG_IGN) /* under nohup, go on ignoring it */
        sigaction(SIGHUP, &action, NULL);
}

int stop_asked(void)
{
    return asked;
}

void stop_wait(void)
{
    sigset_t watched, before;

    /* Signals are blocked except in sigsuspend, so that one between the test of `asked` and the sleep is not lost. */
    sigemptyset(&watched);
    sigaddset(&watched, SIGINT);
    sigaddset(&watched, SIGTERM);
    sigaddset(&watched, SIGHUP);
    sigprocmask(SIG_BLOCK, &watched, &before);
    while (!asked)
        sigsuspend(&before);
    sigprocmask(SIG_SETMASK, &before, NULL);
}
