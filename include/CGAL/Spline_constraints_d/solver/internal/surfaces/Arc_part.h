// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_PART_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_PART_H

#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Arc_store.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The arcs on the boundary of a box as a store of their own, so that a task may cut them without regard to others; and
what their arcs and vertices become when the cuts of all tasks are put together.

Two tasks on both sides of a plane cut the same arc, each in points that the other one does not know. Since an arc is a
graph over its parameter, the points are in a certain order along it if their parameters differ certainly, and then
each part of one task is one or several parts of both.
*/
class Arc_part
{
  Arc_indices m_arcs;                  // in the store of all
  std::vector<std::size_t> m_vertices; // likewise
  Arc_store m_store;

  std::vector<Arc_indices> m_parts; // of each arc here, in the store of all

public:
  Arc_part(const Arc_store& all, const Arc_indices& arcs) : m_arcs(all.parts_of(arcs))
  {
    std::map<std::size_t, std::size_t> place;
    for (const std::size_t a : m_arcs) {
      Stored_arc arc = all.arcs()[a];
      for (std::size_t& end : arc.ends) {
        const auto [entry, is_new] = place.try_emplace(end, m_vertices.size());
        if (is_new) {
          m_vertices.push_back(end);
          m_store.add_known_vertex(all.shared_vertex(end));
        }
        end = entry->second;
      }
      m_store.add_arc(std::move(arc));
    }
  }

  Arc_store& store() { return m_store; }

  // Of the arcs here that there were to begin with.
  Arc_indices indices() const
  {
    Arc_indices result(m_arcs.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    return result;
  }

  // Puts all that is new into the store of all; false, and nothing has changed, if the order of cuts is not certain.
  bool merge_into(Arc_store& all)
  {
    std::vector<Arc_store::Cuts> cuts;
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
      if (const auto own = cuts_of(i, all))
        cuts.push_back(*own);
      else
        return false;
    for (std::size_t i = m_vertices.size(); i < m_store.number_of_vertices(); ++i)
      m_vertices.push_back(all.add_vertex(m_store.shared_vertex(i)));
    m_parts.assign(m_store.arcs().size(), {});
    for (std::size_t i = 0; i < m_arcs.size(); ++i)
      cut_in(all, i, std::move(cuts[i]));
    for (std::size_t a = 0; a < m_parts.size(); ++a)
      if (m_parts[a].empty() && m_store.arcs()[a].parts.empty()) {
        Stored_arc arc = m_store.arcs()[a];
        for (std::size_t& end : arc.ends)
          end = m_vertices[end];
        m_parts[a].push_back(all.add_arc(std::move(arc)));
      }
    return true;
  }

  // The index of a vertex in the store of all. \pre `merge_into()` was called, for the next one as well.
  std::size_t vertex(std::size_t i) const { return m_vertices[i]; }

  // What an arc is in the store of all, from its first end to the second.
  Arc_indices parts(std::size_t arc) const
  {
    Arc_indices result;
    for (const std::size_t a : m_store.parts_of({arc}))
      result.insert(result.end(), m_parts[a].begin(), m_parts[a].end());
    return result;
  }

  Arc_indices parts(const Arc_indices& arcs) const
  {
    Arc_indices result;
    for (const std::size_t a : arcs) {
      const Arc_indices own = parts(a);
      result.insert(result.end(), own.begin(), own.end());
    }
    return result;
  }

private:
  // The vertices here that cut an arc of those to begin with, by the parts that others have cut it into.
  std::optional<Arc_store::Cuts> cuts_of(std::size_t i, const Arc_store& all) const
  {
    Arc_store::Cuts result;
    const Arc_indices own = m_store.parts_of({i});
    if (own.size() == 1)
      return result;
    const Arc_indices others = all.parts_of({m_arcs[i]});
    for (std::size_t k = 1; k < own.size(); ++k) {
      const std::size_t cut = m_store.arcs()[own[k]].ends[0];
      const auto part = std::find_if(others.begin(), others.end(), [&](std::size_t a) {
        return all.is_between_ends(m_store.vertex(cut), all.arcs()[a]);
      });
      if (part == others.end())
        return std::nullopt;
      result[*part].push_back(cut);
    }
    return result;
  }

  void cut_in(Arc_store& all, std::size_t i, Arc_store::Cuts&& cuts)
  {
    for (auto& [a, vertices] : cuts) {
      for (std::size_t& v : vertices)
        v = m_vertices[v];
      all.cut(a, vertices);
    }
    const Arc_indices merged = all.parts_of({m_arcs[i]});
    auto next = merged.begin();
    for (const std::size_t part : m_store.parts_of({i})) {
      const std::size_t end = m_vertices[m_store.arcs()[part].ends[1]];
      do
        m_parts[part].push_back(*next);
      while (all.arcs()[*next++].ends[1] != end);
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_PART_H
