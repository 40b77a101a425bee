/*
 * stop.c - see stop.h.
 */
#include "stop.h"

#include <signal.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#define SAME_REQUEST_NS 1000000000 /* timeout(1) and a shell that loses its terminal send a signal twice */

static const int watched[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
#define WATCHED (sizeof watched / sizeof watched[0])

static volatile sig_atomic_t asked;
static int64_t asked_ns; /* when; only the handler uses it, and no watched signal interrupts that */

static void ask(int number)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    int64_t now_ns = now.tv_sec * (int64_t)1000000000 + now.tv_nsec;
    if (!asked) {
        asked_ns = now_ns;
        asked = 1;
    } else if (number != SIGPIPE && now_ns - asked_ns > SAME_REQUEST_NS) {
        /* The bus hangs: end as without a handler, after returning. A pipe's end says nothing of that. */
        (void)signal(number, SIG_DFL);
        (void)raise(number);
    }
}

static void fill(sigset_t *set)
{
    sigemptyset(set);
    for (size_t i = 0; i < WATCHED; i++)
        sigaddset(set, watched[i]);
}

void stop_watch(void)
{
    struct sigaction action = {.sa_handler = ask}, before; /* no SA_RESTART, so that sleeps end */

    fill(&action.sa_mask);
    for (size_t i = 0; i < WATCHED; i++) {
        /* Under nohup, go on ignoring SIGHUP. SIGINT is ignored in what a script starts with &, and yet must work. */
        int keep = watched[i] == SIGHUP || watched[i] == SIGPIPE;
        if (!keep || (sigaction(watched[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN))
            sigaction(watched[i], &action, NULL);
    }
}

int stop_asked(void)
{
    return asked;
}

void stop_wait(void)
{
    sigset_t all, before;

    /* Signals are blocked except in sigsuspend, so that one between the test of `asked` and the sleep is not lost. */
    fill(&all);
    sigprocmask(SIG_BLOCK, &all, &before);
    while (!asked)
        sigsuspend(&before);
    sigprocmask(SIG_SETMASK, &before, NULL);
}
