// SPDX-License-Identifier: MIT
// Chooses the kernel for the processor.
#include <cstdlib>
#include <cstring>

#include "kernel/kernel.hpp"
#include "platform/cpu.hpp"

namespace mgdt {

extern const Kernel baseline_kernel;
#if defined(MGDT_HAVE_X86_KERNELS)
extern const Kernel avx2_kernel;
extern const Kernel avx512_kernel;
#elif defined(MGDT_HAVE_NEON_KERNEL)
extern const Kernel neon_kernel;
#endif

const Kernel* find_kernel(const char* name) noexcept {
#if defined(MGDT_HAVE_X86_KERNELS)
    const CpuFeatures cpu = cpu_features();
    const Kernel* const runs[] = {cpu.avx512 ? &avx512_kernel : nullptr,
                                  cpu.avx2 ? &avx2_kernel : nullptr, &baseline_kernel};
#elif defined(MGDT_HAVE_NEON_KERNEL)
    const Kernel* const runs[] = {&neon_kernel, &baseline_kernel};
#else
    const Kernel* const runs[] = {&baseline_kernel};
#endif
    for (const Kernel* kernel : runs)
        if (kernel && (!name || std::strcmp(name, kernel->isa) == 0)) return kernel;
    return nullptr;
}

const Kernel& default_kernel() noexcept {
    const Kernel* named = find_kernel(std::getenv("MGDT_ISA"));
    return named ? *named : *find_kernel(nullptr);
}

}  // namespace mgdt
