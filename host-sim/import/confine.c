/*
 * confine.c - makes a process give up everything except reading files and computing: sets
 * limits, then loads a filter of system calls with libseccomp.
 */
#include "confine.h"

#include <errno.h>
#include <fcntl.h>
#include <seccomp.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
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

/* Sets a soft and a hard limit, neither above the hard limit that the process already has. */
static int limit(int resource, rlim_t most, rlim_t at_last)
{
    struct rlimit has;

    if (getrlimit(resource, &has) != 0)
        return -1;
    at_last = at_last < has.rlim_max ? at_last : has.rlim_max;
    return setrlimit(resource, &(struct rlimit){most < at_last ? most : at_last, at_last});
}

/* Memory that this process may allocate, 0 if it is not confined, and the files for which that has been raised. */
static struct {
    rlim_t most;
    struct {
        dev_t device;
        ino_t number;
    } file[64];
    size_t files;
} memory;

/* The hard limit of memory: enough for files of up to 1 GB, or 3 GB of memory if rlim_t has only 32 bits. */
#define MEMORY_AT_LAST ((rlim_t)(sizeof(rlim_t) > 4 ? (uint64_t)SHEEN_CONFINE_TIMES << 30 : (uint64_t)3 << 30))

/* Bytes of private writable memory, which RLIMIT_DATA counts; 0 without /proc. */
static rlim_t memory_now(void)
{
    unsigned long data = 0;
    FILE *file = fopen("/proc/self/statm", "re");

    if (file && fscanf(file, "%*u %*u %*u %*u %*u %lu", &data) != 1)
        data = 0;
    if (file)
        fclose(file);
    return (rlim_t)data * (rlim_t)sysconf(_SC_PAGESIZE);
}

static int set_limits(unsigned seconds, unsigned long bytes)
{
    memory.most = memory_now() + bytes;
    int failed = limit(RLIMIT_CPU, seconds, seconds + 1) || limit(RLIMIT_CORE, 0, 0) || limit(RLIMIT_FSIZE, 0, 0) ||
                 limit(RLIMIT_NOFILE, 64, 64) || (!SANITIZED && limit(RLIMIT_DATA, memory.most, MEMORY_AT_LAST));
    return failed ? -errno : 0;
}

void sheen_confine_file(int file)
{
    struct stat status;

    if (memory.most == 0 || fstat(file, &status) != 0 || memory.files == sizeof memory.file / sizeof memory.file[0])
        return;
    for (size_t i = 0; i < memory.files; i++) {
        if (memory.file[i].device == status.st_dev && memory.file[i].number == status.st_ino)
            return;
    }
    memory.file[memory.files].device = status.st_dev;
    memory.file[memory.files++].number = status.st_ino;
    memory.most += SHEEN_CONFINE_TIMES * (rlim_t)status.st_size;
    if (!SANITIZED)
        (void)limit(RLIMIT_DATA, memory.most, MEMORY_AT_LAST);
}

/*
 * Allows calls with certain arguments only: opening to read, memory that is not executable, writing to `output`,
 * signals to the process itself.
 */
static int allow_with_arguments(scmp_filter_ctx filter, int output)
{
    const unsigned reading = SANITIZED ? 0 : O_NONBLOCK; /* the sanitizers' reports open /proc in their own way */
    const unsigned mode = O_ACCMODE | O_CREAT | O_TRUNC | O_APPEND | reading;
    const struct {
        int call;
        struct scmp_arg_cmp argument;
    } rules[] = {
        {SCMP_SYS(openat), SCMP_A2(SCMP_CMP_MASKED_EQ, mode, reading)},
        {SCMP_SYS(open), SCMP_A1(SCMP_CMP_MASKED_EQ, mode, reading)},
        {SCMP_SYS(mmap), SCMP_A2(SCMP_CMP_MASKED_EQ, 4 /* PROT_EXEC */, 0)},
        {SCMP_SYS(mmap2), SCMP_A2(SCMP_CMP_MASKED_EQ, 4, 0)},
        {SCMP_SYS(mprotect), SCMP_A2(SCMP_CMP_MASKED_EQ, 4, 0)},
        {SCMP_SYS(write), SCMP_A0(SCMP_CMP_EQ, (scmp_datum_t)output, 0)},
        {SCMP_SYS(writev), SCMP_A0(SCMP_CMP_EQ, (scmp_datum_t)output, 0)},
        {SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, (scmp_datum_t)getpid(), 0)}, /* abort() */
        {SCMP_SYS(setrlimit), SCMP_A0(SCMP_CMP_EQ, RLIMIT_DATA, 0)},
        {SCMP_SYS(prlimit64), SCMP_A1(SCMP_CMP_EQ, RLIMIT_DATA, 0)}, /* glibc's setrlimit calls it */
    };
    int error = 0;

    for (size_t i = 0; !error && i < sizeof rules / sizeof rules[0]; i++)
        error = seccomp_rule_add(filter, SCMP_ACT_ALLOW, rules[i].call, 1, rules[i].argument);
    if (!error && SANITIZED) /* the sanitizer's reports */
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
