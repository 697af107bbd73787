// SPDX-License-Identifier: MIT
// Collective calls that agree first whether some process has failed: then all throw the same Error,
// and none waits for another that has left.
//
// What a process does between these calls may throw. It is caught by the outermost function, which
// reports it: that meets the next call of the others.
#pragma once

#include "parts/transport.hpp"
#include "platform/error.hpp"
#include "platform/objects.hpp"

namespace mgdt {

class Collective {
  public:
    Collective(Transport& transport, Allocator& allocator);

    PartId parts() const { return transport_.parts(); }
    PartId first_local() const { return transport_.first_local(); }
    PartId local_parts() const { return transport_.local_parts(); }

    // Of records, as many for each part.
    template <class T>
    void gather(const Buffer<T>& mine, Buffer<T>& all) {
        const std::size_t each = mine.size() / local_parts();
        all.resize(each * parts());
        agree(nullptr);
        transport_.gather(mine.data(), each * sizeof(T), all.data());
    }
    void sum(Buffer<std::uint64_t>& numbers) {
        agree(nullptr);
        transport_.sum(numbers.data(), numbers.size());
    }
    void least(Buffer<double>& numbers) {
        agree(nullptr);
        transport_.least(numbers.data(), numbers.size());
    }
    template <class Record>
    void exchange(const Objects<Mail>& out, Objects<Mail>& in) {
        for (Mail& mail : in) mail.begin.resize(std::size_t{parts()} + 1);
        agree(nullptr);
        transport_.exchange_counts(out.begin(), in.begin());
        for (Mail& mail : in) mail.bytes.resize(mail.count() * sizeof(Record));
        agree(nullptr);
        transport_.exchange_records(sizeof(Record), out.begin(), in.begin());
    }

    // Throws where a process has failed. The end of what all do together.
    void finish() { agree(nullptr); }
    // Calls body, and reports what it throws.
    template <class Body>
    void run(const Body& body) {
        has_failed_ = false;
        try {
            body();
            finish();
        } catch (const Error& error) {
            report(error);
        } catch (const std::bad_alloc&) {
            report(Error{MGDT_ERR_OUT_OF_MEMORY, "out of memory"});
        }
    }

  private:
    struct Failure {
        std::uint64_t has_failed;
        Error error;
    };
    void agree(const Error* mine);
    // Throws it, or that of the first part that has failed.
    [[noreturn]] void report(const Error& error);

    Transport& transport_;
    Buffer<Failure> mine_, all_;
    bool has_failed_ = false;
};

}  // namespace mgdt
