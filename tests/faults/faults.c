/* SPDX-License-Identifier: MIT */
#include "faults.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

static atomic_uint armed;
static atomic_llong counted, first, last, balance, errors;
static atomic_llong requests[fault_kinds];
static atomic_int watching;
/* What is taken from the system for the handle is not a request of the library's. Volatile, since
 * malloc is declared never to come back here, as it does by way of interpose.c. */
static _Thread_local volatile int exempt;

void fault_arm(unsigned kinds, int64_t from, int64_t to) {
    int k;
    for (k = 0; k < fault_kinds; ++k) atomic_store(&requests[k], 0);
    atomic_store(&counted, 0);
    atomic_store(&first, from);
    atomic_store(&last, to);
    atomic_store(&armed, kinds);
    atomic_store(&watching, 1);
}

int64_t fault_disarm(void) {
    atomic_store(&watching, 0);
    atomic_store(&armed, 0);
    return atomic_load(&counted);
}

static int place_of(unsigned kind) {
    int k = 0;
    while (kind >> k != 1) ++k;
    return k;
}

int64_t fault_requests(unsigned kind) {
    return atomic_load(&requests[place_of(kind)]);
}

int fault_is_due(unsigned kind) {
    long long now;
    if (!atomic_load(&watching) || exempt != 0) return 0;
    atomic_fetch_add(&requests[place_of(kind)], 1);
    if (!(atomic_load(&armed) & kind)) return 0;
    now = atomic_fetch_add(&counted, 1) + 1;
    return now >= atomic_load(&first) && now < atomic_load(&last);
}

int64_t fault_balance(void) {
    return atomic_load(&balance);
}

void fault_took(int64_t blocks) {
    if (exempt == 0) atomic_fetch_add(&balance, blocks);
}

int64_t handle_errors(void) {
    return atomic_load(&errors);
}

/* ---------------------------------------------------------------------- the handle's allocator */

typedef struct {
    size_t size, align;
    uint64_t magic;
} header;

static const uint64_t living = UINT64_C(0x6D67647420697321);

static size_t room_before(size_t align) {
    return align > sizeof(header) ? align : (sizeof(header) + align - 1) / align * align;
}

void* handle_take(size_t size, size_t align, void* user) {
    header h;
    unsigned char* raw;
    void* block = NULL;
    (void)user;
    if (fault_is_due(fault_handle)) return NULL;
    if (size == 0 || align == 0 || (align & (align - 1)) != 0) atomic_fetch_add(&errors, 1);
    ++exempt;
    if (posix_memalign(&block, align < sizeof block ? sizeof block : align,
                       size + room_before(align)) != 0)
        block = NULL;
    --exempt;
    if (block == NULL) return NULL;
    raw = (unsigned char*)block + room_before(align);
    h.size = size;
    h.align = align;
    h.magic = living;
    memcpy(raw - sizeof h, &h, sizeof h);
    memset(raw, 0xA5, size); /* nobody may count on zeros */
    atomic_fetch_add(&balance, 1);
    return raw;
}

void handle_give(void* p, size_t size, size_t align, void* user) {
    header h;
    unsigned char* const block = p;
    (void)user;
    memcpy(&h, block - sizeof h, sizeof h);
    if (h.magic != living || h.size != size || h.align != align) {
        atomic_fetch_add(&errors, 1);
        return;
    }
    h.magic = 0;
    memcpy(block - sizeof h, &h, sizeof h);
    memset(block, 0x5A, size);
    atomic_fetch_add(&balance, -1);
    ++exempt;
    free(block - room_before(align));
    --exempt;
}
