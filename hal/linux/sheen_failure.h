/*
 * sheen_failure.h - error messages for people: one sentence that names the GPIO line or path and says what to do.
 *
 * A code (enum sheen_error) tells only the kind of failure. On Linux the kernel
 * knows more, and whoever wires a panel needs to know it. Functions of hal/linux
 * that can fail take a struct sheen_failure and write their message into it.
 */
#ifndef SHEEN_FAILURE_H
#define SHEEN_FAILURE_H

#ifdef __cplusplus
extern "C" {
#endif

/* What went wrong, in words. */
struct sheen_failure {
    char text[320]; /* without a line end; longer messages are cut */
};

/* Writes the message, unless `why` is NULL; returns code. */
int sheen_failed(struct sheen_failure *why, int code, const char *format, ...) __attribute__((format(printf, 3, 4)));

/*
 * Whether to repeat a system call that failed with errno `error`: yes after EINTR or
 * EAGAIN, until *tries, which the caller sets to SHEEN_TRIES, is used up.
 */
#define SHEEN_TRIES 1000
int sheen_again(int error, int *tries);

#ifdef __cplusplus
}
#endif
#endif
