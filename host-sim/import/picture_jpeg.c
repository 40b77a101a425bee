/*
 * picture_jpeg.c - reads JPEG with libjpeg, row by row. Files that need more memory, such as progressive ones, get it
 * within the limits of the process.
 */
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>

#include <jerror.h>
#include <jpeglib.h>

#include "picture.h"

struct reading {
    struct jpeg_error_mgr manager; /* first member: libjpeg passes a pointer to it back */
    jmp_buf end;
    const char *name;
    struct sheen_problem *problem;
    int error;
    uint8_t *row;
};

static _Noreturn void fail(j_common_ptr jpeg)
{
    struct reading *reading = (struct reading *)(void *)jpeg->err;
    char why[JMSG_LENGTH_MAX];

    reading->error = jpeg->err->msg_code == JERR_OUT_OF_MEMORY ? SHEEN_ERR_MEMORY : SHEEN_ERR_ARGUMENT;
    jpeg->err->format_message(jpeg, why);
    sheen_problem(reading->problem, reading->error, "%s: a broken JPEG: %s", reading->name, why);
    longjmp(reading->end, 1);
}

/* Refuses files that end too early or have broken pixels: libjpeg would only warn and make up the rest. */
static void warn(j_common_ptr jpeg, int level)
{
    int code = jpeg->err->msg_code;

    if (level < 0 &&
        (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE || code == JWRN_MUST_RESYNC))
        fail(jpeg);
}

static void read_rows(struct jpeg_decompress_struct *jpeg, struct sheen_reducing *reducing, struct reading *reading,
                      const unsigned most[2])
{
    jpeg_read_header(jpeg, TRUE);
    reading->error =
        sheen_reducing_open(reducing, jpeg->image_width, jpeg->image_height, most, reading->name, reading->problem);
    if (reading->error)
        return;
    jpeg->out_color_space = JCS_RGB;
    jpeg_start_decompress(jpeg);
    reading->row = malloc(3 * (size_t)jpeg->output_width);
    if (!reading->row)
        ERREXIT1(jpeg, JERR_OUT_OF_MEMORY, 0);
    while (jpeg->output_scanline < jpeg->output_height) {
        unsigned y = jpeg->output_scanline;
        JSAMPROW row = reading->row;
        jpeg_read_scanlines(jpeg, &row, 1);
        sheen_reducing_row(reducing, y, 0, 1, jpeg->output_width, row, 3);
    }
    jpeg_finish_decompress(jpeg);
}

int sheen_jpeg_reduce(struct sheen_reducing *reducing, const unsigned char *bytes, size_t count, const unsigned most[2],
                      const char *name, struct sheen_problem *problem)
{
    struct jpeg_decompress_struct jpeg = {.err = NULL};
    struct reading reading = {.name = name, .problem = problem};

    jpeg.err = jpeg_std_error(&reading.manager);
    reading.manager.error_exit = fail;
    reading.manager.emit_message = warn;
    if (setjmp(reading.end) == 0) {
        jpeg_create_decompress(&jpeg);
        jpeg_mem_src(&jpeg, bytes, (unsigned long)count);
        read_rows(&jpeg, reducing, &reading, most);
    }
    jpeg_destroy_decompress(&jpeg);
    free(reading.row);
    return reading.error;
}
