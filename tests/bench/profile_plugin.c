/*
 * profile_plugin.c - a plugin for qemu that counts how often each instruction runs in one measured frame.
 *
 *   -plugin FILE,begin=ADDRESS,end=ADDRESS,frame=N,out=FILE
 *
 * Counting starts when `begin` runs for the Nth time, from 0 on, and stops at `end`. It writes a line per instruction:
 * its address (hexadecimal) and how often it ran (decimal). Debian ships qemu's plugins without their header, so what
 * is used of version 1 of the interface is declared here (qemu, "QEMU TCG Plugins").
 */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct qemu_plugin_tb;
struct qemu_plugin_insn;
typedef uint64_t qemu_plugin_id_t;

size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *tb);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *tb, size_t index);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *insn);
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id,
                                           void (*callback)(qemu_plugin_id_t, struct qemu_plugin_tb *));
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *tb, void (*callback)(unsigned, void *), int flags,
                                          void *data);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, void (*callback)(qemu_plugin_id_t, void *), void *data);

__attribute__((visibility("default"))) int qemu_plugin_version = 1;
__attribute__((visibility("default"))) int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int count,
                                                               char **option);

/* Instructions that run one after another. */
struct block {
    struct block *next;
    uint64_t runs;
    size_t count;
    uint64_t address[];
};

static struct block *blocks;
static uint64_t begin_at, end_at;
static long frames, wanted;
static int counting;
static const char *out;

static void executed(unsigned cpu, void *data)
{
    struct block *block = data;

    (void)cpu;
    if (block->address[0] == end_at)
        counting = 0;
    if (block->address[0] == begin_at)
        counting = frames++ == wanted;
    block->runs += (uint64_t)counting;
}

static void translated(qemu_plugin_id_t id, struct qemu_plugin_tb *tb)
{
    size_t count = qemu_plugin_tb_n_insns(tb);
    struct block *block = calloc(1, sizeof *block + count * sizeof block->address[0]);

    (void)id;
    if (block == NULL)
        abort();
    block->count = count;
    for (size_t i = 0; i < count; i++)
        block->address[i] = qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(tb, i));
    block->next = blocks;
    blocks = block;
    qemu_plugin_register_vcpu_tb_exec_cb(tb, executed, 0, block);
}

static void leave(qemu_plugin_id_t id, void *data)
{
    FILE *file = fopen(out, "w");

    (void)id;
    (void)data;
    if (file == NULL) {
        perror(out);
        return;
    }
    for (const struct block *block = blocks; block != NULL; block = block->next)
        for (size_t i = 0; block->runs > 0 && i < block->count; i++)
            fprintf(file, "%" PRIx64 " %" PRIu64 "\n", block->address[i], block->runs);
    if (fclose(file) != 0)
        perror(out);
}

int qemu_plugin_install(qemu_plugin_id_t id, const void *info, int count, char **option)
{
    (void)info;
    for (int i = 0; i < count; i++) {
        const char *value = strchr(option[i], '=');
        if (value++ == NULL)
            return -1;
        if (strncmp(option[i], "begin=", 6) == 0)
            begin_at = strtoull(value, NULL, 0);
        else if (strncmp(option[i], "end=", 4) == 0)
            end_at = strtoull(value, NULL, 0);
        else if (strncmp(option[i], "frame=", 6) == 0)
            wanted = strtol(value, NULL, 0);
        else if (strncmp(option[i], "out=", 4) == 0)
            out = strdup(value);
    }
    if (out == NULL)
        return -1;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_atexit_cb(id, leave, NULL);
    return 0;
}
