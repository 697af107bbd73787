// SPDX-License-Identifier: MIT
// Collective calls with errors. Before each call, the processes agree whether one of them has
// failed; then all throw the same Error, and no process waits for another that has left.
//
// The code between collective calls may throw. run() catches the exception and reports the error to
// the other processes, which receive the report in their next collective call.
#pragma once

#include "parts/transport.hpp"
#include "platform/error.hpp"
#include "platform/objects.hpp"

namespace mgdt {

class Collective {
  public:
    // Neither the constructor nor a report of a failure allocates memory.
    explicit Collective(Transport& transport) : transport_(transport) { leave_part(); }

    PartId parts() const { return transport_.parts(); }
    PartId first_local() const { return transport_.first_local(); }
    PartId local_parts() const { return transport_.local_parts(); }

    // Gathers records; each part has the same number of records.
    template <class T>
    void gather(const Buffer<T>& mine, Buffer<T>& all) {
        const std::size_t each = mine.size() / local_parts();
        Buffer<std::uint64_t> begin(all.allocator(), std::size_t{parts()} + 1);
        for (std::size_t p = 0; p <= parts(); ++p) begin[p] = p * each * sizeof(T);
        all.resize(each * parts());
        agree(nullptr);
        require(transport_.gather(mine.data(), begin.data(), all.data()));
    }
    // Gathers records; each process has its own number of records.
    template <class T>
    void gather_all(const Buffer<T>& mine, Buffer<T>& all) {
        Buffer<std::uint64_t> begin(all.allocator(), std::size_t{parts()} + 1),
            sizes(all.allocator()), size(all.allocator());
        size.resize(local_parts(), 0);
        size[0] = mine.size() * sizeof(T);
        gather(size, sizes);
        begin[0] = 0;
        for (std::size_t p = 0; p < parts(); ++p) begin[p + 1] = begin[p] + sizes[p];
        all.resize(bytes_of(begin[parts()], 1) / sizeof(T));
        agree(nullptr);
        require(transport_.gather(mine.data(), begin.data(), all.data()));
    }
    void sum(Buffer<std::uint64_t>& numbers) {
        agree(nullptr);
        require(transport_.sum(numbers.data(), numbers.size()));
    }
    void least(Buffer<double>& numbers) {
        agree(nullptr);
        require(transport_.least(numbers.data(), numbers.size()));
    }
    template <class Record>
    void exchange(const Objects<Mail>& out, Objects<Mail>& in) {
        for (Mail& mail : in) mail.begin.resize(std::size_t{parts()} + 1);
        agree(nullptr);
        require(transport_.exchange_counts(out.begin(), in.begin()));
        for (Mail& mail : in) mail.bytes.resize(bytes_of(mail.begin.back(), sizeof(Record)));
        agree(nullptr);
        require(transport_.exchange_records(sizeof(Record), out.begin(), in.begin()));
    }

    // Calls body(i) for each local part. The report of an error in body(i) names the part.
    template <class Body>
    void each_local(const Body& body) {
        for (PartId i = 0; i < local_parts(); ++i) {
            part_ = first_local() + i;
            body(i);
        }
        leave_part();
    }
    // The reports of later errors name no part.
    void name_no_part() { part_ = no_part; }
    // Throws on all processes if one of them has failed. This is the last call of collective work.
    void finish() { agree(nullptr); }
    // Calls body(). If one process throws, all throw the same Error.
    template <class Body>
    void run(const Body& body) {
        has_failed_ = false;
        leave_part();
        try {
            body();
            finish();
        } catch (const Error& error) {
            report(error);
        } catch (const std::bad_alloc&) {
            report(Error{MGDT_ERR_OUT_OF_MEMORY, "out of memory"});
        } catch (...) {
            report(Error{MGDT_ERR_INTERNAL, "internal error"});
        }
    }

  private:
    static constexpr PartId no_part = 0xFFFFFFFF;

    void leave_part() { part_ = local_parts() == 1 ? first_local() : no_part; }
    void agree(const Error* mine);
    void require(bool succeeded);
    // Throws the error of the first part that has failed.
    [[noreturn]] void report(const Error& error);

    Transport& transport_;
    PartId part_;  // the part that reports of errors name, or no_part
    bool has_failed_ = false;
};

}  // namespace mgdt
