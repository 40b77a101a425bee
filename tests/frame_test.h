/*
 * frame_test.h - the common beginning of test programs for whole frames: cmocka, and a stage for a group of tests.
 */
#ifndef FRAME_TEST_H
#define FRAME_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_stage.h"

static struct stage stage;

static int make_stage(void **state)
{
    (void)state;
    return stage_make(&stage);
}

static int free_stage(void **state)
{
    (void)state;
    stage_free(&stage);
    return 0;
}

#endif
