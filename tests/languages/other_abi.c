/* SPDX-License-Identifier: MIT
 * A library of another binary interface: every binding must refuse it. */
#include <stdint.h>

int32_t mgdt_abi_version(void);

int32_t mgdt_abi_version(void) {
    return 2;
}
