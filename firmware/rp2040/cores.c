/*
 * cores.c - runs work on the RP2040's second core, through the FIFOs between the two (data sheet, 2.3.1.4 and 2.8.2).
 *
 * Core 0 sends a function and its argument; core 1 sends a word when the function has returned. A core that waits for
 * a word sleeps until the other core's SEV. Otherwise the two share only what the lock guards in sheen.
 */
#include "cores.h"

#include "board.h"
#include "registers.h"
#include "ticks.h"

#define FIFO_VALID 1u /* status bit: there is a word to read */
#define FIFO_READY 2u /* status bit: there is room to write a word */
#define FIFO_DEPTH 8
#define VTOR REG(0xE000ED08u)
#define STACK_BYTES 1536u  /* enough for a band and its push (tests/boards/sizes) */
#define PATIENCE_US 10000u /* ample: the boot ROM answers within a few microseconds */

static uint64_t core_1_stack[STACK_BYTES / 8];
static int started;

/* Orders memory accesses: earlier writes reach the other core, and later reads see what that core has written. */
static inline void fence(void)
{
    __asm volatile("dmb" ::: "memory");
}

static void fifo_send(uint32_t word)
{
    while (!(SIO_FIFO_STATUS & FIFO_READY))
        ;
    fence();
    SIO_FIFO_WRITE = word;
    __asm volatile("sev");
}

static uint32_t fifo_receive(void)
{
    while (!(SIO_FIFO_STATUS & FIFO_VALID))
        __asm volatile("wfe");
    uint32_t word = SIO_FIFO_READ;
    fence();
    return word;
}

__attribute__((noreturn)) static void run_core_1(void)
{
    for (;;) {
        void (*work)(void *ctx) = (void (*)(void *))(uintptr_t)fifo_receive();
        void *ctx = (void *)(uintptr_t)fifo_receive();

        work(ctx);
        fifo_send(1);
    }
}

/* ---- start ---- */

/* Whether the next word from core 1 is `word`; 0 also if none comes in time. */
static int answers(uint32_t word, uint32_t since)
{
    while (!(SIO_FIFO_STATUS & FIFO_VALID))
        if (ticks() - since > ticks_of_us(PATIENCE_US))
            return 0;
    return SIO_FIFO_READ == word;
}

/* Discards the words that core 1 has sent. */
static void drop_words(void)
{
    for (int i = 0; i < FIFO_DEPTH && (SIO_FIFO_STATUS & FIFO_VALID); i++)
        (void)SIO_FIFO_READ;
}

/* Core 1 has been held in reset since start_board(). When released, it empties its own FIFO and sends 0. */
static int release_core_1(uint32_t since)
{
    while (!(REG(PSM_FRCE_OFF) & PSM_PROC1))
        ;
    SIO_LOCK = 0;
    drop_words();
    CLEAR(PSM_FRCE_OFF) = PSM_PROC1;
    return answers(0, since);
}

/* In the boot ROM core 1 answers each of these words by the same word; after a wrong answer they start again. */
void cores_open(void)
{
    const uint32_t words[] = {
        0, 0, 1, VTOR, (uint32_t)(uintptr_t)&core_1_stack[STACK_BYTES / 8], (uint32_t)(uintptr_t)run_core_1};
    const unsigned count = sizeof words / sizeof words[0];
    const uint32_t since = ticks();
    unsigned sent = 0;

    if (!release_core_1(since))
        return;
    while (sent < count && ticks() - since <= ticks_of_us(PATIENCE_US)) {
        if (words[sent] == 0)
            drop_words();
        fifo_send(words[sent]);
        sent = answers(words[sent], since) ? sent + 1 : 0;
    }
    started = sent == count;
}

/* ---- the functions of board.h ---- */

static void crew_start(void (*work)(void *ctx), void *ctx)
{
    fifo_send((uint32_t)(uintptr_t)work);
    fifo_send((uint32_t)(uintptr_t)ctx);
}

static void crew_join(void)
{
    (void)fifo_receive();
}

static void crew_lock(void *ctx)
{
    (void)ctx;
    while (!SIO_LOCK)
        ;
    fence();
}

static void crew_unlock(void *ctx)
{
    (void)ctx;
    fence();
    SIO_LOCK = 0;
}

const struct demo_crew *board_crew(void)
{
    static const struct demo_crew crew = {crew_start, crew_join, crew_lock, crew_unlock};

    return started ? &crew : NULL;
}

unsigned board_core(void)
{
    return SIO_CPUID;
}
