/*
 * no_lecture.c - replaces cmd_lecture.c if sheen is built without cairo or fontconfig.
 */
#include "commands.h"

enum sheen_exit sheen_cmd_lecture(struct sheen_options *options)
{
    struct sheen_problem problem;

    (void)options;
    sheen_problem(&problem, SHEEN_ERR_UNSUPPORTED,
                  "lecture: built without cairo and fontconfig, which draw the figures; on Debian: "
                  "apt install libcairo2-dev libfontconfig-dev, and build again");
    return sheen_fail(SHEEN_EXIT_FAILURE, &problem);
}
