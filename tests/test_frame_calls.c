/*
 * test_frame_calls.c - random sequences of calls against the model in call_model.h: calls in any order, workers in each
 * other's bands, failing pushes and waits, views and backgrounds that change, capacities that are too small.
 *
 *   test_frame_calls          30,000 sequences
 *   test_frame_calls all      10^6
 *   test_frame_calls from N   starting with sequence N, which a failure names
 */
#include <stdlib.h>
#include <string.h>

#include "call_player.h"
#include "frame_test.h"

#define CALLS 40 /* per sequence; one of them may stand for all bands of a frame */

static unsigned first_sequence, sequences = 30000;
static struct player *failing; /* the sequence being played */

static struct call_counts met;

static void random_sequences(void **state)
{
    static struct player p;

    (void)state;
    failing = &p;
    for (unsigned i = 0; i < sequences; i++) {
        player_open(&p, &stage, first_sequence + i, &met);
        while (p.calls < CALLS)
            player_call(&p);
        player_close(&p);
    }
    failing = NULL;
    print_message("  %u sequences, %u frames arrived, %u of them with triangles, %u of them not sent whole\n",
                  sequences, met.frames, met.drawn, met.incremental);
    print_message("  %u bands in the midst of others, %u frames that failed\n", met.nested, met.failures);
    assert_true(met.drawn > sequences / 4 && met.incremental > sequences / 20);
    assert_true(met.nested > sequences / 10 && met.failures > sequences / 10 && met.clipped > sequences / 20);
}

static int name_sequence(void **state)
{
    (void)state;
    if (failing != NULL)
        print_message("  sequence %u, call %u: test_frame_calls from %u\n", failing->number, failing->calls,
                      failing->number);
    return 0;
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test_teardown(random_sequences, name_sequence)};

    if (argc > 1 && strcmp(argv[1], "all") == 0)
        sequences = 1000000;
    if (argc > 2 && strcmp(argv[1], "from") == 0)
        first_sequence = (unsigned)strtoul(argv[2], NULL, 10);
    return cmocka_run_group_tests_name("frame_calls", tests, make_stage, free_stage);
}
