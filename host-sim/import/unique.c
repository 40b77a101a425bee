/*
 * unique.c - gives equal records the same number, with a hash table with open addressing.
 */
#include "unique.h"

#include <stdlib.h>
#include <string.h>

#include "sheen_target.h"

/* Multiply and fold, 4 bytes at a time (size is a multiple of 4). */
static uint64_t hash(const unsigned char *record, size_t size)
{
    uint64_t h = 0x9e3779b97f4a7c15u;

    for (size_t i = 0; i < size; i += 4) {
        uint32_t word;
        memcpy(&word, record + i, sizeof word);
        h = (h ^ word) * 0xff51afd7ed558ccdu;
        h ^= h >> 32;
    }
    return h;
}

int sheen_unique(const void *records, size_t size, size_t count, uint32_t *ids, size_t *distinct)
{
    const unsigned char *bytes = records;
    size_t slots = 16;

    while (slots < 2 * count)
        slots *= 2;
    uint32_t *table = calloc(slots, sizeof *table); /* index + 1 of the first record with this value; 0: free */
    if (!table)
        return SHEEN_ERR_MEMORY;

    *distinct = 0;
    for (size_t i = 0; i < count; i++) {
        size_t slot = hash(bytes + i * size, size) & (slots - 1);
        while (table[slot] && memcmp(bytes + (table[slot] - 1) * size, bytes + i * size, size) != 0)
            slot = (slot + 1) & (slots - 1);
        if (!table[slot]) {
            table[slot] = (uint32_t)i + 1;
            ids[i] = (uint32_t)(*distinct)++;
        } else {
            ids[i] = ids[table[slot] - 1];
        }
    }
    free(table);
    return SHEEN_OK;
}
