// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_FORMULA_EXPANSION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_FORMULA_EXPANSION_H

#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/Sum_of_products.h>
#include <CGAL/Spline_constraints_d/function/internal/Symbol_table.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A polynomial in splines of unknowns, as a function of the unknowns.

Its monomials are products of functions of few unknowns each. Those on the same unknowns become one dense tensor per
cell; monomials on some of these unknowns join it where that makes no more coefficients. Within such a part, unknowns
that some spline has as axes together form a block; every monomial is a product of one vector for each block, which
holds the coefficients of all cells, and equal ones are computed once. All of this is done in integers over one
denominator.
*/
class Formula_expansion
{
  // What a part knows of one unknown.
  struct Axis
  {
    int degree = 0;
    Breaks_of_axis breaks;
  };

  struct Summand
  {
    const Monomial* monomial;
    Big_integer scale;
    std::map<int, Axis> axes;
  };

  struct Part
  {
    std::map<int, Axis> axes;   // by unknown
    std::vector<const Summand*> summands;

    double size() const
    {
      double result = 1;
      for (const auto& [unknown, axis] : axes)
        result *= (axis.degree + 1.0) * static_cast<double>(cells_between(axis.breaks));
      return result;
    }

    void join(const Part& other)
    {
      for (const auto& [unknown, axis] : other.axes) {
        Axis& own = axes[unknown];
        own.degree = (std::max)(own.degree, axis.degree);
        own.breaks = united(own.breaks, axis.breaks);
      }
      summands.insert(summands.end(), other.summands.begin(), other.summands.end());
    }

    bool has_all_unknowns_of(const Part& other) const
    {
      return std::all_of(other.axes.begin(), other.axes.end(),
                         [&](const auto& axis) { return axes.count(axis.first) != 0; });
    }
  };

  // Coefficients in the cells of a block.
  struct Tensor
  {
    std::vector<int> degrees;
    std::vector<std::vector<Big_integer>> pieces;
  };

  struct Block
  {
    std::vector<int> unknowns;   // increasing
    std::vector<int> degrees;
    std::vector<Breaks_of_axis> breaks;
    std::map<Monomial, Tensor> tensors;
    std::map<Monomial, std::size_t> index;   // of a monomial among the vectors

    std::vector<int> last_cells() const { return Integer_pieces<Big_integer>{degrees, breaks, {}}.last_cells(); }
  };

  static constexpr double maximal_size = 0x1p24;   // coefficients of a part, all cells together

  const Symbol_table& m_symbols;
  const Power_polynomial m_polynomial;
  std::vector<Summand> m_summands;
  Big_integer m_denominator = 1;
  mutable Interruption m_interruption;

public:
  // \pre no symbol of the polynomial stands for a formula
  Formula_expansion(const Symbol_table& symbols, Power_polynomial polynomial, std::function<void()> check = {})
    : m_symbols(symbols), m_polynomial(std::move(polynomial)), m_interruption(std::move(check))
  {
    std::vector<Exact_rational> scales;
    for (const auto& [monomial, coefficient] : m_polynomial.terms()) {
      Summand& summand = m_summands.emplace_back(Summand{&monomial, 0, {}});
      Big_integer denominator(1);
      for (const auto& [index, exponent] : monomial.powers)
        add_factor(summand, denominator, index, exponent);
      scales.push_back(coefficient / scaled_rational(denominator, 0));
      extend_common_denominator(m_denominator, scales.back());
    }
    for (std::size_t i = 0; i < scales.size(); ++i)
      m_summands[i].scale = numerator_over(scales[i], m_denominator);
  }

  // The positive integer that the function has to be multiplied by to have the coefficients of `scaled_function()`.
  const Big_integer& denominator() const { return m_denominator; }

  Formula_expansion(const Formula_expansion&) = delete;   // summands point into the polynomial
  Formula_expansion& operator=(const Formula_expansion&) = delete;

  // The function times `denominator()`, in integers.
  Spline_function scaled_function() const
  {
    std::vector<Spline_term> terms;
    for (const Part& part : parts()) {
      Spline_term term = dense_term(part);
      if (!term.degrees.empty() || term.pieces[0][0] != 0)
        terms.push_back(std::move(term));
    }
    if (terms.empty())
      terms.push_back(Spline_term{{}, {}, {}, {{Exact_rational(0)}}});
    Spline_function result;
    for (Spline_term& term : terms)
      result += Spline_function(std::move(term));
    return result;
  }

  // The same as one term, with all unknowns.
  Spline_term scaled_term() const
  {
    Part all;
    for (const Summand& summand : m_summands)
      all.join({summand.axes, {&summand}});
    return dense_term(all);
  }

private:
  void add_factor(Summand& summand, Big_integer& denominator, int index, int exponent) const
  {
    const Symbol& symbol = m_symbols[index];
    switch (symbol.kind) {
    case Symbol::Kind::UNKNOWN: summand.axes[index].degree += exponent; return;
    case Symbol::Kind::SPLINE: break;
    case Symbol::Kind::FORMULA:
      CGAL_assertion(false);
      return;
    case Symbol::Kind::VALUE:
      m_symbols.require_no_values(Power_polynomial::variable(index), "Constraint");
      return;
    case Symbol::Kind::WITHOUT_RANGE:
      throw Invalid_input("Constraint: an unknown without a range is left in a formula, solve_linear() eliminates it");
    }
    for (std::size_t j = 0; j < symbol.unknowns.size(); ++j) {
      Axis& axis = summand.axes[symbol.unknowns[j]];
      axis.degree += exponent * symbol.spline->degrees()[j];
      axis.breaks = united(axis.breaks, symbol.spline->breaks()[j]);
    }
    for (int k = 0; k < exponent; ++k)
      denominator *= symbol.spline->denominator();
  }

  // Monomials on the same unknowns, and on some of these where that does not cost more.
  std::vector<Part> parts() const
  {
    std::map<std::set<int>, Part> by_unknowns;
    for (const Summand& summand : m_summands) {
      std::set<int> unknowns;
      for (const auto& [unknown, axis] : summand.axes)
        unknowns.insert(unknown);
      by_unknowns[unknowns].join({summand.axes, {&summand}});
    }
    std::vector<Part> result;
    for (auto& [unknowns, part] : by_unknowns)
      result.push_back(std::move(part));
    std::stable_sort(result.begin(), result.end(),
                     [](const Part& a, const Part& b) { return a.axes.size() < b.axes.size(); });
    for (std::size_t i = 0; i < result.size();) {
      const auto host = best_host(result, i);
      if (host == result.size()) {
        ++i;
        continue;
      }
      result[host].join(result[i]);
      result.erase(result.begin() + i);
    }
    return result;
  }

  // The part with all unknowns of part `i` that grows least when this one joins it, if the sum of the sizes does not
  // grow; else the number of parts.
  static std::size_t best_host(const std::vector<Part>& parts, std::size_t i)
  {
    std::size_t best = parts.size();
    double least_growth = parts[i].size();
    for (std::size_t k = i + 1; k < parts.size(); ++k) {
      if (!parts[k].has_all_unknowns_of(parts[i]))
        continue;
      Part together{parts[k].axes, {}};
      together.join({parts[i].axes, {}});
      const double growth = together.size() - parts[k].size();
      if (growth < least_growth || (growth == least_growth && best == parts.size())) {
        least_growth = growth;
        best = k;
      }
    }
    return best;
  }

  Spline_term dense_term(const Part& part) const
  {
    double piece_size = 1;
    for (const auto& [unknown, axis] : part.axes)
      piece_size *= axis.degree + 1.0;
    if (piece_size > static_cast<double>(Spline_function::maximal_piece_size) || part.size() > maximal_size)
      throw Invalid_input("Constraint: a formula in " + std::to_string(part.axes.size()) +
                          " connected unknowns has too many coefficients as a dense tensor");
    std::vector<Block> blocks = blocks_of(part);
    std::vector<Sum_of_products::Factor> factors;
    std::vector<Sum_of_products::Product> products = products_of(part, blocks, factors);
    const Sum_of_products sum(factors, std::move(products));
#ifdef CGAL_SPLINE_CONSTRAINTS_D_HAS_WIDE_INTEGER
    if (sum.bits() < 127)
      return term_of(part, blocks, sum.sum<Wide_integer>(m_interruption));
#endif
    return term_of(part, blocks, sum.sum<Big_integer>(m_interruption));
  }

  // Unknowns that a spline has as axes together.
  std::vector<Block> blocks_of(const Part& part) const
  {
    std::map<int, int> first;   // the least unknown of the block
    for (const auto& [unknown, axis] : part.axes)
      first[unknown] = unknown;
    for (const Summand* summand : part.summands)
      for (const auto& [index, exponent] : summand->monomial->powers)
        for (int unknown : m_symbols[index].unknowns) {
          const int a = first[unknown], b = first[m_symbols[index].unknowns.front()];
          for (auto& [other, least] : first)
            if (least == (std::max)(a, b))
              least = (std::min)(a, b);
        }
    std::map<int, Block> blocks;
    for (const auto& [unknown, axis] : part.axes) {
      Block& block = blocks[first[unknown]];
      block.unknowns.push_back(unknown);
      block.degrees.push_back(axis.degree);
      block.breaks.push_back(axis.breaks);
    }
    std::vector<Block> result;
    for (auto& [least, block] : blocks)
      result.push_back(std::move(block));
    return result;
  }

  // Every monomial as a product of vectors, one for each block; the blocks are reordered, those with the fewest vectors
  // first.
  std::vector<Sum_of_products::Product> products_of(const Part& part, std::vector<Block>& blocks,
                                                    std::vector<Sum_of_products::Factor>& factors) const
  {
    for (const Summand* summand : part.summands)
      for (Block& block : blocks)
        block.index.emplace(restricted(*summand->monomial, block), block.index.size());
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const Block& a, const Block& b) { return a.index.size() < b.index.size(); });
    for (Block& block : blocks) {
      auto& factor =
          factors.emplace_back(Sum_of_products::Factor{0, std::vector<std::vector<Big_integer>>(block.index.size())});
      for (const auto& [monomial, index] : block.index)
        factor.vectors[index] = vector_of(block, tensor(block, monomial));
      factor.length = factor.vectors.front().size();
    }
    std::vector<Sum_of_products::Product> result;
    for (const Summand* summand : part.summands) {
      auto& product = result.emplace_back(Sum_of_products::Product{{}, summand->scale});
      for (const Block& block : blocks)
        product.vectors.push_back(block.index.at(restricted(*summand->monomial, block)));
    }
    return result;
  }

  // The factors of a monomial on the unknowns of a block.
  Monomial restricted(const Monomial& monomial, const Block& block) const
  {
    Monomial result;
    for (const auto& power : monomial.powers) {
      const int unknown = m_symbols.is_unknown(power.first) ? power.first : m_symbols[power.first].unknowns.front();
      if (std::binary_search(block.unknowns.begin(), block.unknowns.end(), unknown))
        result.powers.push_back(power);
    }
    return result;
  }

  const Tensor& tensor(Block& block, const Monomial& monomial) const
  {
    const auto position = block.tensors.find(monomial);
    if (position != block.tensors.end())
      return position->second;
    Tensor result;
    if (monomial.powers.empty())
      result = {std::vector<int>(block.unknowns.size(), 0),
                std::vector<std::vector<Big_integer>>(tensor_size(block.last_cells()), {Big_integer(1)})};
    else {
      const auto [symbol, exponent] = monomial.powers.back();
      if (monomial.powers.size() == 1 && exponent == 1)
        result = m_symbols.is_unknown(symbol) ? tensor_of_unknown(block, symbol)
                                              : tensor_of_spline(block, m_symbols[symbol]);
      else {
        const Tensor& rest = tensor(block, monomial.with_exponent(symbol, exponent - 1));
        const Tensor& last = tensor(block, Monomial{{{symbol, 1}}});
        const Convolution_shape shape(rest.degrees, last.degrees);
        result.degrees = shape.result;
        for (std::size_t c = 0; c < rest.pieces.size(); ++c)
          result.pieces.push_back(convolved(shape, rest.pieces[c], last.pieces[c]));
      }
    }
    return block.tensors.emplace(monomial, std::move(result)).first->second;
  }

  static std::size_t place_of(int unknown, const Block& block)
  {
    return static_cast<std::size_t>(std::lower_bound(block.unknowns.begin(), block.unknowns.end(), unknown) -
                                    block.unknowns.begin());
  }

  static Tensor tensor_of_unknown(const Block& block, int unknown)
  {
    Tensor result{
        std::vector<int>(block.unknowns.size(), 0),
        std::vector<std::vector<Big_integer>>(tensor_size(block.last_cells()), {Big_integer(0), Big_integer(1)})};
    result.degrees[place_of(unknown, block)] = 1;
    return result;
  }

  static Tensor tensor_of_spline(const Block& block, const Symbol& symbol)
  {
    const Integer_spline& spline = *symbol.spline;
    std::vector<std::size_t> places;
    Tensor result{std::vector<int>(block.unknowns.size(), 0), {}};
    for (std::size_t j = 0; j < symbol.unknowns.size(); ++j) {
      places.push_back(place_of(symbol.unknowns[j], block));
      result.degrees[places[j]] = spline.degrees()[j];
    }
    std::vector<Breaks_of_axis> breaks;
    for (std::size_t place : places)
      breaks.push_back(block.breaks[place]);
    const std::vector<std::size_t> strides = tensor_strides(result.degrees);
    for_each_index(block.last_cells(), [&](const std::vector<int>& cell) {
      std::vector<int> own_cell;
      for (std::size_t place : places)
        own_cell.push_back(cell[place]);
      auto next = spline.piece_on(breaks, own_cell).begin();
      auto& piece = result.pieces.emplace_back(tensor_size(result.degrees));
      for_each_index(spline.degrees(), [&](const std::vector<int>& index) {
        std::size_t position = 0;
        for (std::size_t j = 0; j < index.size(); ++j)
          position += strides[places[j]] * static_cast<std::size_t>(index[j]);
        piece[position] = *next++;
      });
    });
    return result;
  }

  // All cells one after the other, with the degrees of the block.
  static std::vector<Big_integer> vector_of(const Block& block, const Tensor& tensor)
  {
    std::vector<Big_integer> result;
    const std::vector<int> origin(block.degrees.size(), 0);
    for (const auto& piece : tensor.pieces) {
      const std::size_t begin = result.size();
      result.resize(begin + tensor_size(block.degrees), Big_integer(0));
      auto next = piece.begin();
      for_each_position(block.degrees, origin, tensor.degrees,
                        [&](std::size_t position) { result[begin + position] = *next++; });
    }
    return result;
  }

  // Brings the axes, which are cells and powers of one block after the other, into the order of the unknowns, cells
  // first.
  template <class Integer>
  Spline_term term_of(const Part& part, const std::vector<Block>& blocks, const std::vector<Integer>& sum) const
  {
    std::vector<int> extents;
    for (const Block& block : blocks) {
      const std::vector<int> cells = block.last_cells();
      extents.insert(extents.end(), cells.begin(), cells.end());
      extents.insert(extents.end(), block.degrees.begin(), block.degrees.end());
    }
    const std::vector<std::size_t> strides = tensor_strides(extents);
    std::map<int, std::pair<std::size_t, std::size_t>> strides_of;   // cells and powers of an unknown
    std::size_t first = 0;
    for (const Block& block : blocks) {
      for (std::size_t j = 0; j < block.unknowns.size(); ++j)
        strides_of[block.unknowns[j]] = {strides[first + j], strides[first + block.unknowns.size() + j]};
      first += 2 * block.unknowns.size();
    }
    Integer_pieces<Integer> result;
    std::vector<int> unknowns;
    std::vector<std::size_t> cell_strides, power_strides;
    for (const auto& [unknown, axis] : part.axes) {
      unknowns.push_back(unknown);
      result.degrees.push_back(axis.degree);
      result.breaks.push_back(axis.breaks);
      cell_strides.push_back(strides_of[unknown].first);
      power_strides.push_back(strides_of[unknown].second);
    }
    const std::vector<std::size_t> power_offsets = offsets(result.degrees, power_strides);
    for (std::size_t cell : offsets(result.last_cells(), cell_strides)) {
      auto& piece = result.pieces.emplace_back();
      piece.reserve(power_offsets.size());
      m_interruption.add_work(power_offsets.size());
      for (std::size_t power : power_offsets)
        piece.push_back(sum[cell + power]);
    }
    result.simplify();
    Spline_term term;
    for (int axis : result.remove_trivial_axes())
      term.variables.push_back(unknowns[axis]);
    term.degrees = result.degrees;
    term.breaks = result.breaks;
    for (const auto& piece : result.pieces) {
      m_interruption.add_work(piece.size());
      term.pieces.push_back(to_rationals<Exact_rational>(piece));
    }
    return term;
  }

  static std::vector<std::size_t> offsets(const std::vector<int>& extents, const std::vector<std::size_t>& strides)
  {
    std::vector<std::size_t> result;
    for_each_index(extents, [&](const std::vector<int>& index) {
      std::size_t offset = 0;
      for (std::size_t j = 0; j < index.size(); ++j)
        offset += strides[j] * static_cast<std::size_t>(index[j]);
      result.push_back(offset);
    });
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_FORMULA_EXPANSION_H
