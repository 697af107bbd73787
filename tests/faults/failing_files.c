/* SPDX-License-Identifier: MIT
 * Stands before the system calls on files of a program that is run with LD_PRELOAD. MGDT_FAULT says
 * what goes wrong: "CALL N ERRNO" fails the N-th call of read, write, fsync, close, rename,
 * mkostemp or fstat (those on standard streams and on libraries at start aside); "short" reads and
 * writes seven bytes at a time, every second time interrupted by a signal first. MGDT_FAULT_COUNT
 * names a file that gets a byte when the fault happened. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "next.h"

static void happened(void) {
    static ssize_t (*real_write)(int, const void*, size_t);
    static int (*real_close)(int);
    const char* const path = getenv("MGDT_FAULT_COUNT");
    int file;
    if (path == NULL) return;
    LOOK_UP(real_write, "write");
    LOOK_UP(real_close, "close");
    file = open(path, O_WRONLY | O_APPEND | O_CREAT, 0600);
    if (file < 0 || real_write(file, "x", 1) != 1) abort();
    real_close(file);
}

/* Whether this call, of so many, is the one; sets errno. */
static int fails(const char* call, int* calls) {
    const char* const fault = getenv("MGDT_FAULT");
    char name[16];
    int nth, error;
    if (fault == NULL || sscanf(fault, "%15s %d %d", name, &nth, &error) != 3) return 0;
    if (strcmp(name, call) != 0 || ++*calls != nth) return 0;
    happened();
    errno = error;
    return 1;
}

static int is_short(void) {
    const char* const fault = getenv("MGDT_FAULT");
    return fault != NULL && strcmp(fault, "short") == 0;
}

/* How much of `size` goes through; 0 if it is interrupted. */
static size_t part(size_t size) {
    static int turn;
    if (!is_short()) return size;
    if (++turn == 1) happened();
    if (turn % 2 == 0) {
        errno = EINTR;
        return 0;
    }
    return size < 7 ? size : 7;
}

ssize_t write(int file, const void* data, size_t size) {
    static int calls;
    size_t some;
    NEXT(ssize_t, write, (int, const void*, size_t));
    if (file <= 2) return next(file, data, size);
    if (fails("write", &calls)) return -1;
    some = part(size);
    return some == 0 && size != 0 ? -1 : next(file, data, some);
}

ssize_t read(int file, void* data, size_t size) {
    static int calls;
    size_t some;
    NEXT(ssize_t, read, (int, void*, size_t));
    if (fails("read", &calls)) return -1;
    some = part(size);
    return some == 0 && size != 0 ? -1 : next(file, data, some);
}

int fsync(int file) {
    static int calls;
    NEXT(int, fsync, (int));
    return fails("fsync", &calls) ? -1 : next(file);
}

int close(int file) {
    static int calls;
    int result;
    NEXT(int, close, (int));
    result = next(file); /* the descriptor is gone all the same */
    return fails("close", &calls) ? -1 : result;
}

int rename(const char* from, const char* to) {
    static int calls;
    NEXT(int, rename, (const char*, const char*));
    return fails("rename", &calls) ? -1 : next(from, to);
}

int mkostemp(char* name, int flags) {
    static int calls;
    NEXT(int, mkostemp, (char*, int));
    return fails("mkostemp", &calls) ? -1 : next(name, flags);
}

int fstat(int file, struct stat* status) {
    static int calls;
    NEXT(int, fstat, (int, struct stat*));
    return fails("fstat", &calls) ? -1 : next(file, status);
}
