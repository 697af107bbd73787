/* SPDX-License-Identifier: MIT
 * A plug-in of QEMU that prints how many instructions a program executed. It declares the few
 * functions of QEMU's plug-in interface that it calls, so that it needs no header of QEMU's. */
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>

#define EXPORT __attribute__((visibility("default")))

struct qemu_plugin_tb;
typedef uint64_t plugin_id;

extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb* block);
extern void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id id,
                                                  void (*translated)(plugin_id id,
                                                                     struct qemu_plugin_tb* block));
/* Operation 0 adds to *sum. */
extern void qemu_plugin_register_vcpu_tb_exec_inline(struct qemu_plugin_tb* block, int operation,
                                                     void* sum, uint64_t addend);
extern void qemu_plugin_register_atexit_cb(plugin_id id, void (*ended)(plugin_id id, void* data),
                                           void* data);
extern void qemu_plugin_outs(const char* text);

EXPORT extern const int qemu_plugin_version;
EXPORT extern int qemu_plugin_install(plugin_id id, const void* info, int argc, char** argv);

const int qemu_plugin_version = 1;

static uint64_t executed;

static void on_translation(plugin_id id, struct qemu_plugin_tb* block) {
    (void)id;
    qemu_plugin_register_vcpu_tb_exec_inline(block, 0, &executed, qemu_plugin_tb_n_insns(block));
}

static void on_end(plugin_id id, void* data) {
    char text[64];
    (void)id;
    (void)data;
    snprintf(text, sizeof text, "instructions %" PRIu64 "\n", executed);
    qemu_plugin_outs(text);
}

int qemu_plugin_install(plugin_id id, const void* info, int argc, char** argv) {
    (void)info;
    (void)argc;
    (void)argv;
    qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
    qemu_plugin_register_atexit_cb(id, on_end, NULL);
    return 0;
}
