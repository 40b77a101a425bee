/*
 * report_json.c - a plan as one JSON object, in seconds, bytes and frames per second.
 */

#include "report.h"
#include "utf8.h"

static void put_quoted(FILE *out, const char *text)
{
    putc('"', out);
    while (*text) {
        size_t bytes = sheen_utf8_bytes(text);
        if (bytes == 0)
            putc('?', out); /* JSON is UTF-8, which a file's name need not be */
        else if (*text == '"' || *text == '\\')
            fprintf(out, "\\%c", *text);
        else if ((unsigned char)*text < ' ')
            fprintf(out, "\\u%04x", *text);
        else
            fwrite(text, 1, bytes, out);
        text += bytes ? bytes : 1;
    }
    putc('"', out);
}

static void put_times(FILE *out, const char *name, const struct sheen_plan_times *times, unsigned cores)
{
    const struct sheen_plan_time *t = &times->mean;

    fprintf(out, "\"%s\": {", name);
    for (unsigned i = 0; i < SHEEN_PLAN_STAGES; i++)
        fprintf(out, "\"%s\": %.7f, ", sheen_plan_stage_names[i], t->stage[i]);
    fprintf(out, "\"bus\": %.7f, \"bytes\": %.0f, ", t->bus, times->bytes);
    fprintf(out, "\"one_buffer\": {\"mean\": %.2f, \"worst\": %.2f}, ", 1 / t->period[0], 1 / times->worst[0]);
    fprintf(out, "\"two_buffers\": {\"mean\": %.2f, \"worst\": %.2f}", 1 / t->period[1], 1 / times->worst[1]);
    if (cores > 1)
        fprintf(out, ", \"two_cores\": {\"mean\": %.2f, \"worst\": %.2f}", 1 / t->period[SHEEN_PLAN_TWO_CORES],
                1 / times->worst[SHEEN_PLAN_TWO_CORES]);
    fputs("}", out);
}

static void put_board(FILE *out, const struct sheen_plan *plan, unsigned number)
{
    const struct sheen_plan_board *b = sheen_plan_board_at(number);
    const struct sheen_plan_flash *f = &plan->flash[number];

    fputs("{\"board\": ", out);
    put_quoted(out, b->name);
    fprintf(out, ", \"processor\": \"%s\", \"hz\": %u, \"bus_hz\": %.0f, \"measured\": %s, \"basis\": ", b->processor,
            b->clock_hz, sheen_plan_bus_hz(plan, b), b->measured ? "true" : "false");
    put_quoted(out, b->basis);
    fputs(", ", out);
    put_times(out, "changed", &plan->times[number][0], b->cores);
    fputs(", ", out);
    put_times(out, "whole", &plan->times[number][1], b->cores);
    fprintf(out,
            ", \"flash\": {\"all\": %u, \"core\": %u, \"panel\": %u, \"mesh\": %u, \"tables\": %u, \"textures\": %u, "
            "\"all_Os\": %u, "
            "\"has\": %u, \"short\": %u}, \"ram\": {\"has\": %u, \"short\": %u}, \"limit\": \"%s\"}",
            f->all, f->core, f->panel, f->mesh, f->tables, f->textures, f->small, b->flash,
            sheen_plan_flash_short(plan, number), b->ram, sheen_plan_ram_short(plan, b),
            sheen_plan_limit(plan, number));
}

void sheen_plan_json(FILE *out, const struct sheen_plan *plan, int board)
{
    const struct sheen_plan_ram *r = &plan->ram;

    fputs("{\"mesh\": ", out);
    put_quoted(out, plan->options->mesh);
    fprintf(out,
            ", \"shade\": \"%s\", \"look\": \"%s\", \"panel\": \"%s\", \"width\": %u, \"height\": %u, \"band\": %u, "
            "\"views\": %d",
            sheen_shading_word(plan->shade), plan->look + (*plan->look ? 2 : 0), plan->panel, plan->target.width,
            plan->target.height, sheen_plan_band_rows(plan), SHEEN_PLAN_VIEWS);
    fprintf(out, ", \"vertices\": %u, \"triangles\": %u, \"used\": %u, \"listed\": %u, \"costs\": ", plan->vertices,
            plan->triangles, plan->used, plan->listed);
    put_quoted(out, sheen_plan_found);
    fprintf(out,
            ", \"ram\": {\"all\": %u, \"arena\": %u, \"vertices\": %u, \"lists\": %u, \"bands\": %u, \"rest\": %u, "
            "\"stack\": %u, \"second_core\": %u, \"least\": %u, \"max_used\": %u, \"max_triangles\": %u, "
            "\"max_carried\": %u}, \"boards\": [",
            r->all, r->arena, r->vertices, r->lists, r->bands, r->rest, SHEEN_PLAN_STACK, r->second_core,
            plan->least.all, plan->counted.max_used, plan->counted.max_triangles, plan->counted.max_carried);
    for (unsigned i = 0; sheen_plan_board_at(i); i++) {
        if (board >= 0 && i != (unsigned)board)
            continue;
        if (i > 0 && board < 0)
            fputs(", ", out);
        put_board(out, plan, i);
    }
    fputs("]}\n", out);
}
