/*
 * confine.c - a process gives up everything but reading files and computing: limits, then a
 * filter of system calls by libseccomp.
 */
#include "confine.h"

#include <errno.h>
#include <fcntl.h>
#include <seccomp.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#else
#define SANITIZED 0
#endif

/* Reading, memory, time, and what the C and C++ libraries do to end or abort. */
static const int allowed[] = {
    SCMP_SYS(read),         SCMP_SYS(readv),           SCMP_SYS(pread64),     SCMP_SYS(lseek),
    SCMP_SYS(_llseek),      SCMP_SYS(close),           SCMP_SYS(fstat),       SCMP_SYS(fstat64),
    SCMP_SYS(stat),         SCMP_SYS(stat64),          SCMP_SYS(lstat),       SCMP_SYS(lstat64),
    SCMP_SYS(newfstatat),   SCMP_SYS(fstatat64),       SCMP_SYS(statx),       SCMP_SYS(access),
    SCMP_SYS(faccessat),    SCMP_SYS(faccessat2),      SCMP_SYS(readlink),    SCMP_SYS(readlinkat),
    SCMP_SYS(getcwd),       SCMP_SYS(fadvise64),       SCMP_SYS(brk),         SCMP_SYS(munmap),
    SCMP_SYS(mremap),       SCMP_SYS(madvise),         SCMP_SYS(futex),       SCMP_SYS(futex_time64),
    SCMP_SYS(sched_yield),  SCMP_SYS(sysinfo),         SCMP_SYS(getrandom),   SCMP_SYS(clock_gettime),
    SCMP_SYS(gettimeofday), SCMP_SYS(getpid),          SCMP_SYS(gettid),      SCMP_SYS(rt_sigaction),
    SCMP_SYS(rt_sigreturn), SCMP_SYS(rt_sigprocmask),  SCMP_SYS(sigaltstack), SCMP_SYS(exit),
    SCMP_SYS(exit_group),   SCMP_SYS(restart_syscall),
};

/* No reader of meshes ever makes these. */
static const int hostile[] = {
    SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(socket), SCMP_SYS(socketcall), SCMP_SYS(ptrace),
    SCMP_SYS(fork),   SCMP_SYS(vfork),    SCMP_SYS(clone),  SCMP_SYS(clone3),     SCMP_SYS(kill),
};

static int limit(int resource, rlim_t most)
{
    return setrlimit(resource, &(struct rlimit){most, most});
}

static int set_limits(unsigned seconds, unsigned long bytes)
{
    int failed = setrlimit(RLIMIT_CPU, &(struct rlimit){seconds, seconds + 1}) || limit(RLIMIT_CORE, 0) ||
                 limit(RLIMIT_FSIZE, 0) || limit(RLIMIT_NOFILE, 64);

    if (!SANITIZED && limit(RLIMIT_AS, bytes))
        failed = 1;
    alarm(seconds); /* also for one that waits rather than computes */
    return failed ? -errno : 0;
}

/* Only these ways of a call: opening to read, memory that is not executable, writing to `output`, ending oneself. */
static int allow_with_arguments(scmp_filter_ctx filter, int output)
{
    const unsigned writing = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND;
    const struct {
        int call;
        struct scmp_arg_cmp argument;
    } rules[] = {
        {SCMP_SYS(openat), SCMP_A2(SCMP_CMP_MASKED_EQ, writing, 0)},
        {SCMP_SYS(open), SCMP_A1(SCMP_CMP_MASKED_EQ, writing, 0)},
        {SCMP_SYS(mmap), SCMP_A2(SCMP_CMP_MASKED_EQ, 4 /* PROT_EXEC */, 0)},
        {SCMP_SYS(mmap2), SCMP_A2(SCMP_CMP_MASKED_EQ, 4, 0)},
        {SCMP_SYS(mprotect), SCMP_A2(SCMP_CMP_MASKED_EQ, 4, 0)},
        {SCMP_SYS(write), SCMP_A0(SCMP_CMP_EQ, (scmp_datum_t)output, 0)},
        {SCMP_SYS(writev), SCMP_A0(SCMP_CMP_EQ, (scmp_datum_t)output, 0)},
        {SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, (scmp_datum_t)getpid(), 0)}, /* abort() */
    };
    int error = 0;

    for (size_t i = 0; !error && i < sizeof rules / sizeof rules[0]; i++)
        error = seccomp_rule_add(filter, SCMP_ACT_ALLOW, rules[i].call, 1, rules[i].argument);
    if (!error && SANITIZED) /* its reports */
        error = seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(write), 1, SCMP_A0(SCMP_CMP_EQ, 2, 0));
    return error;
}

static int set_filter(int output)
{
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_ERRNO(EPERM));
    int error = filter ? allow_with_arguments(filter, output) : -ENOMEM;

    for (size_t i = 0; !error && i < sizeof allowed / sizeof allowed[0]; i++)
        error = seccomp_rule_add(filter, SCMP_ACT_ALLOW, allowed[i], 0);
    for (size_t i = 0; !error && i < sizeof hostile / sizeof hostile[0]; i++)
        error = seccomp_rule_add(filter, SCMP_ACT_KILL_PROCESS, hostile[i], 0);
    if (!error)
        error = seccomp_load(filter);
    if (filter)
        seccomp_release(filter);
    return error;
}

int sheen_confine(int output, unsigned seconds, unsigned long bytes, struct sheen_problem *problem)
{
    int error = set_limits(seconds, bytes);

    if (!error)
        error = set_filter(output);
    if (!error)
        return SHEEN_OK;
    return sheen_problem(problem, SHEEN_ERR_UNSUPPORTED, "the importer cannot be confined on this system: %s",
                         strerror(-error));
}
