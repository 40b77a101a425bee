/*
 * unique.h - gives equal records the same number.
 */
#ifndef SHEEN_UNIQUE_H
#define SHEEN_UNIQUE_H

#include <stddef.h>
#include <stdint.h>

/*
 * records: count of `size` bytes each, without padding; equal means every byte.
 * ids[i] becomes the number of record i, counted from 0 in the order of first appearance,
 * *distinct the number of different records. count < 2^31. 0, or SHEEN_ERR_MEMORY.
 */
int sheen_unique(const void *records, size_t size, size_t count, uint32_t *ids, size_t *distinct);

#endif
