// SPDX-License-Identifier: MIT
#include "improvement/smoothing.hpp"

#include <algorithm>

namespace mgdt {
namespace {

constexpr unsigned most_colors = 64;

}  // namespace

void Smoothing::choose_candidates(const Buffer<std::uint32_t>& tetrahedra) {
    candidates_.clear();
    color_.clear();
    color_.resize(mesh_.x.size() / 3, 0);
    for (const std::uint32_t t : tetrahedra)
        for (const std::uint32_t v : mesh_.tetrahedra[t].v) {
            if (color_[v] != 0 || mesh_.classes[v].freedom == Freedom::fixed) continue;
            color_[v] = 1;
            candidates_.push_back(v);
        }
    for (const std::uint32_t v : candidates_) color_[v] = 0;
}

void Smoothing::collect_stars(StageProgress& progress) {
    for (Mover& mover : movers_) mover.tetrahedra.clear();
    stars_.clear();
    stars_.resize(candidates_.size());
    constexpr std::size_t vertices_per_thread = 256;
    team_.split(candidates_.size(), vertices_per_thread,
                [&](std::size_t begin, std::size_t end, unsigned member) {
                    Mover& mover = movers_[member];
                    for (std::size_t k = begin; k < end; ++k) {
                        progress.step(k, begin, end, member);
                        stars_[k] = {mover.tetrahedra.size(), member, 0, false, {0, 0, 0}};
                        if (!mover.star.collect(mesh_, candidates_[k])) continue;
                        for (const std::uint32_t t : mover.star.tetrahedra)
                            mover.tetrahedra.push_back(t);
                        stars_[k].size = static_cast<std::uint32_t>(mover.star.tetrahedra.size());
                    }
                });
}

// Gives vertices of one tetrahedron different colours, and sorts the candidates by colour. A vertex
// that gets none stays where it is.
void Smoothing::color() {
    begin_of_color_.clear();
    begin_of_color_.resize(most_colors + 2, 0);
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
        std::uint64_t used = 0;
        const std::uint32_t* const star = tetrahedra_of(stars_[k]);
        for (std::uint32_t i = 0; i < stars_[k].size; ++i)
            for (const std::uint32_t v : mesh_.tetrahedra[star[i]].v)
                if (color_[v] != 0) used |= std::uint64_t{1} << (color_[v] - 1);
        unsigned color = 0;
        while (color < most_colors && (used >> color & 1) != 0) ++color;
        if (color == most_colors || stars_[k].size == 0) continue;
        color_[candidates_[k]] = static_cast<std::uint8_t>(color + 1);
        ++begin_of_color_[color + 1];
    }
    for (unsigned c = 1; c < begin_of_color_.size(); ++c)
        begin_of_color_[c] += begin_of_color_[c - 1];
    order_.resize(begin_of_color_[most_colors]);
    std::uint32_t next[most_colors];
    std::copy_n(begin_of_color_.begin(), most_colors, next);
    for (std::uint32_t k = 0; k < candidates_.size(); ++k)
        if (const unsigned color = color_[candidates_[k]]; color != 0)
            order_[next[color - 1]++] = k;
}

// Moves the vertices of some tetrahedra. search(search, vertex, place) replaces the place by a
// better one, or returns false if it finds none.
template <class Search>
std::size_t Smoothing::move_all(const Buffer<std::uint32_t>& tetrahedra, StageProgress& progress,
                                const Search& search) {
    choose_candidates(tetrahedra);
    collect_stars(progress);
    color();
    ++mesh_.round;
    try {
        return move_colors(progress, search);
    } catch (...) {
        undo_moves();
        throw;
    }
}

// Moves the vertices, one colour after the other. Returns how many have moved.
template <class Search>
std::size_t Smoothing::move_colors(StageProgress& progress, const Search& search) {
    std::size_t moved = 0;
    constexpr std::size_t vertices_per_thread = 32;
    for (unsigned c = 0; c < most_colors && begin_of_color_[c] < order_.size(); ++c) {
        const std::size_t first = begin_of_color_[c], last = begin_of_color_[c + 1];
        team_.split(last - first, vertices_per_thread,
                    [&](std::size_t begin, std::size_t end, unsigned member) {
                        Mover& mover = movers_[member];
                        for (std::size_t k = begin; k < end; ++k) {
                            progress.step(k, begin, end, member);
                            move(order_[first + k], mover, search);
                        }
                    });
        moved += note_moves(first, last);
    }
    return moved;
}

// Notes which stars have changed, after the moves of a colour: threads share the neighbours of the
// vertices that they move. Returns how many vertices have moved.
std::size_t Smoothing::note_moves(std::size_t begin, std::size_t end) {
    std::size_t moved = 0;
    for (std::size_t k = begin; k < end; ++k) {
        const Star& star = stars_[order_[k]];
        if (!star.has_moved) continue;
        ++moved;
        const std::uint32_t* const tetrahedra = tetrahedra_of(star);
        for (std::uint32_t i = 0; i < star.size; ++i)
            for (const std::uint32_t v : mesh_.tetrahedra[tetrahedra[i]].v) mesh_.note_change(v);
    }
    return moved;
}

template <class Search>
void Smoothing::move(std::uint32_t candidate, Mover& mover, const Search& search) {
    const std::uint32_t v = candidates_[candidate];
    const std::uint32_t* const star = tetrahedra_of(stars_[candidate]);
    const std::uint32_t size = stars_[candidate].size;
    mover.search.clear();
    for (std::uint32_t i = 0; i < size; ++i) {
        // (q, f0, f1, f2) is positive for q beyond the face, so (v, f0, f2, f1) is positive.
        const FlexibleMesh::Tetrahedron& t = mesh_.tetrahedra[star[i]];
        const unsigned char* const f = outer_face[t.position(v)];
        mover.search.add(mesh_.point(t.v[f[0]]), mesh_.point(t.v[f[2]]), mesh_.point(t.v[f[1]]));
    }
    double place[3];
    std::copy_n(mesh_.point(v), 3, place);
    mover.search.evaluate(place);
    if (!search(mover.search, v, place)) return;
    stars_[candidate].has_moved = true;
    std::copy_n(mesh_.point(v), 3, stars_[candidate].place);
    put(candidate, place);
}

// Puts a vertex at a place.
void Smoothing::put(std::uint32_t candidate, const double (&place)[3]) {
    std::copy_n(place, 3, mesh_.x.begin() + 3 * std::size_t{candidates_[candidate]});
    const std::uint32_t* const star = tetrahedra_of(stars_[candidate]);
    for (std::uint32_t i = 0; i < stars_[candidate].size; ++i)
        mesh_.qualities[star[i]] = mesh_.quality(mesh_.tetrahedra[star[i]].v);
}

// Takes a pass back that has been interrupted, so that the mesh is that of the last complete one.
void Smoothing::undo_moves() {
    for (std::uint32_t k = 0; k < stars_.size(); ++k)
        if (stars_[k].has_moved) put(k, stars_[k].place);
}

std::size_t Smoothing::pass(const Buffer<std::uint32_t>& tetrahedra, const Moves& moves,
                            FailedTries::Kind kind, StageProgress& progress) {
    failed_.resize(mesh_.hints.size());
    return move_all(tetrahedra, progress,
                    [&](PlaceSearch& search, std::uint32_t v, double(&place)[3]) {
                        if (failed_.has(v, kind, mesh_.last_change[v])) return false;
                        if (search.improve(mesh_.classes[v], moves, place)) return true;
                        failed_.add(v, kind, mesh_.round, mesh_.last_change[v]);
                        return false;
                    });
}

std::size_t Smoothing::pass_for_mean(const Buffer<std::uint32_t>& tetrahedra, double goal,
                                     StageProgress& progress) {
    return move_all(tetrahedra, progress,
                    [&](PlaceSearch& search, std::uint32_t v, double(&place)[3]) {
                        return search.improve_mean(mesh_.classes[v], goal, place);
                    });
}

}  // namespace mgdt
