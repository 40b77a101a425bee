/*
 * sheen_failure.h - why something failed, for a person: one line that names the line or path and the way out.
 *
 * Codes say what kind of failure it was (enum sheen_error); on Linux the kernel
 * knows more, and whoever wires a panel needs it. Functions of hal/linux that can
 * fail take a struct sheen_failure and leave their sentence there.
 */
#ifndef SHEEN_FAILURE_H
#define SHEEN_FAILURE_H

#ifdef __cplusplus
extern "C" {
#endif

/* What went wrong, in words. */
struct sheen_failure {
    char text[320]; /* without a line end; cut where longer */
};

/* Writes the text, unless `why` is NULL; returns code. */
int sheen_failed(struct sheen_failure *why, int code, const char *format, ...) __attribute__((format(printf, 3, 4)));

/*
 * Whether a system call that failed with errno `error` is to be made again:
 * EINTR or EAGAIN, and *tries, which the caller sets to SHEEN_TRIES, is not used up.
 */
#define SHEEN_TRIES 1000
int sheen_again(int error, int *tries);

#ifdef __cplusplus
}
#endif
#endif
