// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The steps of one node of the subdivision beside what the machine could do.
//
// Names are step/family/unknowns/degree: `dense` is one tensor over all unknowns with as many equations, `curves` the
// two equations of C1(t) = C2(s). Each step is timed in turns with its *roofline*: plain vector loops over as many
// numbers in the same kind of memory, which do nothing but the loads, stores, additions, products and comparisons that
// the step cannot do without; for the linear rows straight elimination, whose divisions wait for each other. Steps with
// such rows let each call wait for a result of the one before. Counters: coefficients of the node; nanoseconds per
// coefficient of the step and of the roofline, medians over the iterations; and their ratio. (The column of times is
// that of a batch of calls.) Steps include those that they need, each from a node of which nothing is known:
//
// split        at one half, along each axis in turn (per axis): the means of de Casteljau's scheme
// restrict     to a part, along each axis in turn (per axis): two cuts
//              (both bring the error bounds up to date, which is in the roofline; so is what tells where to cut: an end
// of both parts for a split, quotients for a restriction)
// bounds       least and largest control point per function, wider by its error
// linear       bounds, slopes and the bounds of what the linear part leaves
// precondition the linear rows: elimination and products, once linear is there
// reduction    linear, precondition and the contraction with the layers of control points
// dense        the control points of C f
// derivatives  bounds, and the bounds of all partial derivatives
// image        linear, precondition, derivatives and the contraction bound

#include <CGAL/Spline_constraints_d/solver/internal/node/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Dense_preconditioner.h>
#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/reductions.h>
#include <CGAL/Spline_constraints_d/solver/termination_tests.h>

#include <benchmark/benchmark.h>

#include <Eigen/Core>

#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::internal::Block;
using SC::internal::System_layout;
using SC::internal::unroll;
using SC::internal::greater, SC::internal::load, SC::internal::magnitude, SC::internal::store;

using Node = SC::internal::Box_node<double>;

// Blocks with as many functions as unknowns.
System_layout make_layout(int unknowns, const std::vector<std::vector<int>>& axes_of_blocks, int degree)
{
  System_layout layout;
  layout.dimension = layout.equalities = layout.functions = unknowns;
  for (const auto& axes : axes_of_blocks) {
    Block& block = layout.blocks.emplace_back();
    block.axes = axes;
    block.degrees.assign(axes.size(), degree);
    block.functions.resize(unknowns);
    std::iota(block.functions.begin(), block.functions.end(), 0);
    for (std::size_t j = 0; j < axes.size(); ++j)
      block.points *= static_cast<std::size_t>(degree) + 1;
  }
  layout.place_blocks();
  return layout;
}

System_layout make_dense(int unknowns, int degree)
{
  std::vector<int> axes(unknowns);
  std::iota(axes.begin(), axes.end(), 0);
  return make_layout(unknowns, {axes}, degree);
}

System_layout make_curves(int degree) { return make_layout(2, {{0}, {1}}, degree); }

// A node with a root near its centre: f_i is near s_i + 0.3 s_{i+1}, so that no test ends early and there is an
// inverse.
Node make_node(const System_layout& layout)
{
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> noise(-0.01, 0.01);
  Node node;
  node.allocate(layout);
  for (const Block& block : layout.blocks)
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::size_t members = block.functions.size();
      const int f = block.functions[i % members];
      double value = noise(engine);
      for (std::size_t j = 0; j < block.axes.size(); ++j) {
        const double s = static_cast<double>(i % block.lengths[j] / block.lengths[j + 1]) / block.degrees[j] - 0.5;
        value += block.axes[j] == f ? s : block.axes[j] == (f + 1) % layout.dimension ? 0.3 * s : 0;
      }
      node.coefficients()[block.offset + i] = value;
    }
  std::fill(node.errors().begin(), node.errors().end(), 0x1p-50);
  std::fill(node.sizes().begin(), node.sizes().end(), 2.0);
  return node;
}

void reset_box(Node& node)
{
  std::fill(node.lower.begin(), node.lower.end(), 0.0);
  std::fill(node.upper.begin(), node.upper.end(), 1.0);
}

// Lets the next call wait for a result of this one, as a node waits for what its parent was contracted to: else the
// machine works on several at once.
void wait_for(double& input, double result)
{
  input += 0 * result;
  benchmark::ClobberMemory();
}

/*
The rooflines. Eight numbers are taken at a time, enough to keep the arithmetic units busy.
*/
class Roofline
{
  static constexpr int width = 8;
  using Numbers = Eigen::Array<double, width, 1>;

  std::vector<double> m_first, m_second, m_third, m_fourth;
  std::array<double, 2> m_ends{0, 1}, m_cuts{0.25, 0.75};

public:
  // For ranges of so many numbers; longer ones are taken in parts.
  explicit Roofline(std::size_t size)
    : m_first(size + width, 0.5), m_second(size + width, 0.25), m_third(size + width, 0.125),
      m_fourth(2 * (size + width), 0.0)
  {}

  // second <- (first + second) / 2, in rows of the whole length.
  void means(std::size_t count)
  {
    for (; count > 0; count -= (std::min)(count, m_first.size())) {
      const std::size_t size = (std::min)(count, m_first.size());
      const double* __restrict a = m_first.data();
      double* __restrict b = m_second.data();
      for (std::size_t i = 0; i < size; ++i)
        b[i] = (a[i] + b[i]) * 0.5;
      benchmark::ClobberMemory();
    }
  }

  // second <- s first + t second, with s = 1 - t.
  void blends(std::size_t count, double t = 0.125)
  {
    const double s = 1 - t;
    for (; count > 0; count -= (std::min)(count, m_first.size())) {
      const std::size_t size = (std::min)(count, m_first.size());
      const double* __restrict a = m_first.data();
      double* __restrict b = m_second.data();
      for (std::size_t i = 0; i < size; ++i)
        b[i] = s * a[i] + t * b[i];
      benchmark::ClobberMemory();
    }
  }

  // The place of a cut between the ends of a range, without which no coefficient can be formed.
  double parameter(int cut) const { return (m_cuts[cut] - m_ends[0]) / (m_ends[1] - m_ends[0]); }

  // A cut between the ends, and whether it is in the middle.
  void cut_in_the_middle()
  {
    const double cut = m_ends[0] + 0.5 * (m_ends[1] - m_ends[0]);
    m_cuts[0] = m_ends[0] < cut && cut < m_ends[1] && cut - m_ends[0] == m_ends[1] - cut ? cut : 0;
    benchmark::ClobberMemory();
  }

  // What a cut adds to the errors, in memory of their own: fourth <- fourth + u (fourth + first).
  void add_errors(std::size_t count)
  {
    const double* __restrict a = m_first.data();
    double* __restrict b = m_fourth.data();
    for (std::size_t i = 0; i < count; ++i)
      b[i] = b[i] + 0x1p-50 * (b[i] + a[i]);
    benchmark::ClobberMemory();
  }

  // Bounds from below and from above become wider by an error, and by what their own size lets the analysis add.
  void widen(std::size_t count)
  {
    const double *error = m_first.data(), *lower = m_second.data(), *upper = m_third.data();
    double *below = m_fourth.data(), *above = below + count;
    SC::internal::for_each_place(count, [=](auto type, std::size_t i) {
      const auto low = load(type, lower + i), high = load(type, upper + i);
      const auto by = load(type, error + i) + greater(magnitude(low), magnitude(high)) * 0x1p-45;
      store(below + i, low - by);
      store(above + i, high + by);
    });
    benchmark::ClobberMemory();
  }

  // third <- third + second.
  void add(std::size_t count)
  {
    const double* __restrict a = m_second.data();
    double* __restrict b = m_third.data();
    for (std::size_t i = 0; i < count; ++i)
      b[i] += a[i];
    benchmark::ClobberMemory();
  }

  void copy(std::size_t size)
  {
    std::copy_n(m_first.data(), size, m_third.data());
    benchmark::ClobberMemory();
  }

  void bound(std::size_t size) const
  {
    accumulate(size, [](const Numbers& x, const double*, Numbers& least, Numbers& most, Numbers&) {
      least = least.min(x);
      most = most.max(x);
    });
  }

  void bound_differences(std::size_t size) const
  {
    accumulate(size, [](const Numbers& x, const double* second, Numbers& least, Numbers& most, Numbers&) {
      const Numbers difference = x - Eigen::Map<const Numbers>(second);
      least = least.min(difference);
      most = most.max(difference);
    });
  }

  void sum(std::size_t size) const
  {
    accumulate(size, [](const Numbers& x, const double*, Numbers&, Numbers&, Numbers& total) { total += x; });
  }

  // What the linear rows cannot do without: the sizes of the rows, for weights and rounding errors; elimination in
  // place, in which each pivot waits for the one before, with as many comparisons as it takes to find the largest entry
  // that is left, and with the radii of the right-hand sides; the products of the inverse with rows and right-hand
  // sides, of these with middles, radii and sizes; and per row a quotient and what the other unknowns add to the
  // radius.
  template <int n>
  void precondition()
  {
    const Square<n> rows = some_rows<n>(),
                    inverse = eliminate<n>(rows, [&](const Square<n>&left, auto k) { weigh<n>(left, k); }),
                    product = multiply<n>(inverse, rows);
    std::array<double, n> size{};
    unroll<n>([&](auto i) { unroll<n>([&](auto k) { size[i] += std::abs(rows[i][k]); }); });
    unroll<n>([&](auto i) {
      double middle = 0, radius = 0, rounding = 0;
      unroll<n>([&](auto k) {
        m_third[i * n + k] = product[i][k];
        middle += inverse[i][k] * m_fourth[k];
        radius += std::abs(inverse[i][k]) * m_fourth[n + k];
        rounding += std::abs(inverse[i][k]) * size[k];
      });
      radius += 0x1p-45 * rounding;
      unroll<n>([&](auto j) { radius += j == i ? 0 : std::abs(product[i][j]); });
      const double factor = 1 / product[i][i];
      m_second[2 * i] = middle * factor;
      m_second[2 * i + 1] = radius * std::abs(factor);
    });
    wait_for(m_first[0], m_second[0]);
  }

  template <int n>
  void invert()
  {
    const Square<n> inverse = eliminate<n>(some_rows<n>(), [](const Square<n>&, auto) {});
    unroll<n>([&](auto i) { unroll<n>([&](auto j) { m_third[i * n + j] = inverse[i][j]; }); });
    wait_for(m_first[0], m_third[0]);
  }

private:
  template <int n>
  using Square = std::array<std::array<double, n>, n>;

  template <int n>
  Square<n> some_rows() const
  {
    Square<n> rows;
    unroll<n>([&](auto i) { unroll<n>([&](auto j) { rows[i][j] = m_first[i * n + j] + (i == j ? 1 : 0); }); });
    return rows;
  }

  // The largest entry of the rows and columns from the k-th on, each row with a weight.
  template <int n>
  void weigh(const Square<n>& rows, int k)
  {
    double largest = 0;
    for (int i = k; i < n; ++i) {
      double entry = 0;
      for (int j = k; j < n; ++j)
        entry = greater(entry, std::abs(rows[i][j]));
      largest = greater(largest, entry * m_fourth[2 * n + i]);
    }
    m_fourth[3 * n + k] = largest;
  }

  // Calls weigh(rows, k) before the k-th pivot.
  template <int n, class Weigh>
  static Square<n> eliminate(Square<n> rows, const Weigh& weigh)
  {
    unroll<n>([&](auto k) {
      weigh(rows, k);
      const double factor = 1 / rows[k][k];
      rows[k][k] = 1;
      unroll<n>([&](auto j) { rows[k][j] *= factor; });
      unroll<n>([&](auto i) {
        if constexpr (i != k) {
          const double a = std::exchange(rows[i][k], 0.0);
          unroll<n>([&](auto j) { rows[i][j] -= a * rows[k][j]; });
        }
      });
    });
    return rows;
  }

  template <int n>
  static Square<n> multiply(const Square<n>& a, const Square<n>& b)
  {
    Square<n> product{};
    unroll<n>(
        [&](auto i) { unroll<n>([&](auto j) { unroll<n>([&](auto k) { product[i][j] += a[i][k] * b[k][j]; }); }); });
    return product;
  }

  template <class Step>
  void accumulate(std::size_t size, const Step& step) const
  {
    const double *first = m_first.data(), *second = m_second.data();
    Numbers least = Numbers::Constant(1), most = Numbers::Constant(-1), total = Numbers::Zero();
    for (std::size_t i = 0; i < size; i += width) {
      const Numbers x = Eigen::Map<const Numbers>(first + i);
      step(x, second + i, least, most, total);
    }
    benchmark::DoNotOptimize(least);
    benchmark::DoNotOptimize(most);
    benchmark::DoNotOptimize(total);
  }
};

double seconds_of_thread()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double median(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Times both in turns, many calls at a time; `calls` is how many steps one call does.
template <class Step, class Plain>
void compare(benchmark::State& state, std::size_t coefficients, int calls, const Step& step, const Plain& plain)
{
  const int batch = static_cast<int>((std::max)(std::size_t(1), 40000 / (coefficients * calls)));
  const auto time = [&](const auto& function) {
    const double start = seconds_of_thread();
    for (int i = 0; i < batch; ++i)
      function();
    return (seconds_of_thread() - start) / batch / calls;
  };
  step();
  plain();
  std::vector<double> times, roofline;
  for (auto _ : state) {
    times.push_back(time(step));
    roofline.push_back(time(plain));
    state.SetIterationTime(times.back() * batch * calls);
  }
  const double scale = 1e9 / static_cast<double>(coefficients), measured = median(times) * scale,
               least = median(roofline) * scale;
  state.counters["coefficients"] = static_cast<double>(coefficients);
  state.counters["ns_per_coefficient"] = measured;
  state.counters["roofline_ns"] = least;
  state.counters["ratio"] = measured / least;
}

// A node with all that looks at it.
struct Fixture
{
  System_layout layout;
  int degree, n;
  std::size_t size;
  Node node = make_node(layout), above = node;
  SC::Node_view view{layout};
  SC::Linear_enclosure linear{layout.dimension, layout.equalities};
  SC::Preconditioned_reduction reduction;
  SC::Local_box box;
  std::vector<double> bounds;
  Roofline roofline{(std::max)(layout.size, 2 * layout.errors + layout.functions + 2 * layout.dimension)};

  Fixture(const System_layout& given_layout, int given_degree)
    : layout(given_layout), degree(given_degree), n(layout.dimension), size(layout.size)
  {
    reset_box(node);
  }

  bool is_dense() const { return layout.blocks.size() == 1; }
  // Coefficients that one axis concerns.
  std::size_t share() const { return size / layout.blocks.size(); }

  void forget() { view.reset(node.coefficients().data(), node.errors().data()); }

  // Rooflines.
  // What a node has beside its coefficients: two bounds per block and function, the scales of the functions and the
  // box.
  void plain_copy_of_the_rest() { roofline.copy(2 * layout.errors + layout.functions + 2 * n); }
  void plain_precondition()
  {
    n == 2 ? roofline.precondition<2>() : n == 3 ? roofline.precondition<3>() : roofline.precondition<4>();
  }
  void plain_invert() { n == 2 ? roofline.invert<2>() : n == 3 ? roofline.invert<3>() : roofline.invert<4>(); }
  // Bounds per block and function, and their sums per function.
  void plain_bounds()
  {
    roofline.bound(size);
    roofline.widen(layout.errors);
    roofline.add(2 * (layout.errors - layout.functions));
  }
  void plain_linear()
  {
    plain_bounds();
    if (is_dense())
      roofline.sum((std::min)(size, 2 * n * size / (degree + 1)));
    else
      roofline.sum(2 * n * layout.blocks.size());
    roofline.bound_differences(size);
    roofline.widen(layout.errors);
  }
  void plain_derivatives()
  {
    for (int j = 0; j < n; ++j) {
      roofline.bound_differences(share());
      roofline.widen(layout.functions);
    }
  }
};

void split(benchmark::State& state, const System_layout& layout, int degree)
{
  Fixture f(layout, degree);
  const auto step = [&] {
    for (int j = 0; j < f.n; ++j) {
      f.node.split(f.layout, j, 0.5, f.above);
      f.node.upper[j] = 1;
    }
  };
  compare(state, f.size, f.n, step, [&] {
    for (int j = 0; j < f.n; ++j) {
      f.roofline.cut_in_the_middle();
      f.roofline.means(f.share() * degree / 2);
      f.roofline.copy(f.size);
      f.roofline.add_errors(f.layout.functions);
      f.plain_copy_of_the_rest();
    }
  });
}

void restrict(benchmark::State& state, const System_layout& layout, int degree)
{
  Fixture f(layout, degree);
  const auto step = [&] {
    for (int j = 0; j < f.n; ++j) {
      f.node.restrict_axis(f.layout, j, 0.25, 0.75);
      f.node.lower[j] = 0;
      f.node.upper[j] = 1;
    }
  };
  compare(state, f.size, f.n, step, [&] {
    for (int j = 0; j < f.n; ++j) {
      f.roofline.blends(f.share() * degree / 2, f.roofline.parameter(0));
      f.roofline.blends(f.share() * degree / 2, f.roofline.parameter(1));
      f.roofline.add_errors(f.layout.functions);
    }
  });
}

void bounds(benchmark::State& state, const System_layout& layout, int degree)
{
  Fixture f(layout, degree);
  const auto step = [&] {
    f.forget();
    benchmark::DoNotOptimize(f.view.lower(0));
  };
  compare(state, f.size, 1, step, [&] { f.plain_bounds(); });
}

void linear(benchmark::State& state, const System_layout& layout, int degree)
{
  Fixture f(layout, degree);
  const auto step = [&] {
    f.forget();
    benchmark::DoNotOptimize(f.view.slopes(0));
  };
  compare(state, f.size, 1, step, [&] { f.plain_linear(); });
}

void precondition(benchmark::State& state, const System_layout& layout, int degree)
{
  Fixture f(layout, degree);
  f.forget();
  double& slope = const_cast<double&>(*f.view.slopes(0));
  const auto step = [&] {
    f.linear.precondition(f.view);
    wait_for(slope, f.linear.reach(0));
  };
  compare(state, f.size, 1, step, [&] { f.plain_precondition(); });
}

void reduction(benchmark::State& state, const System_layout& layout, int degree)
{
  Fixture f(layout, degree);
  const auto step = [&] {
    f.forget();
    f.linear.precondition(f.view);
    f.box.reset(f.n);
    f.reduction.contract(f.view, f.linear, f.box);
    wait_for(f.node.coefficients()[0], f.box.lower[0]);
  };
  compare(state, f.size, 1, step, [&] {
    f.plain_linear();
    f.plain_precondition();
    if (f.is_dense())
      f.roofline.bound(f.size);   // layers along the first axis come with the bounds; those along all others
  });
}

void dense(benchmark::State& state, const System_layout& layout, int degree)
{
  Fixture f(layout, degree);
  SC::internal::Dense_preconditioner preconditioner;
  preconditioner.prepare(f.layout);
  f.forget();
  double& slope = const_cast<double&>(*f.view.slopes(0));
  compare(state, f.size, 1, [&] { wait_for(slope, *preconditioner.apply(f.view)->coefficients()); },
          [&] {
            f.plain_invert();
            f.roofline.blends(f.size * f.n / 2);
            f.roofline.widen(f.n * f.n);   // the error of each product of an entry of C and a function
          });
}

void derivatives(benchmark::State& state, const System_layout& layout, int degree)
{
  Fixture f(layout, degree);
  const auto step = [&] {
    f.forget();
    benchmark::DoNotOptimize(f.view.derivative_lower(0));
  };
  compare(state, f.size, 1, step, [&] {
    f.plain_bounds();
    f.plain_derivatives();
  });
}

void image(benchmark::State& state, const System_layout& layout, int degree)
{
  Fixture f(layout, degree);
  const auto step = [&] {
    f.forget();
    f.linear.precondition(f.view);
    wait_for(f.node.coefficients()[0], SC::contraction_bound(f.view, f.linear, f.bounds));
  };
  compare(state, f.size, 1, step, [&] {
    f.plain_linear();
    f.plain_precondition();
    f.plain_derivatives();
    f.roofline.blends(3 * f.n * f.n * f.n / 2);   // three products per entry of C and of J: middles, radii and rounding
  });
}

using Run = void (*)(benchmark::State&, const System_layout&, int);

void add(const std::string& name, Run run, const System_layout& layout, int degree)
{
  benchmark::RegisterBenchmark((name + '/' + std::to_string(layout.dimension) + '/' + std::to_string(degree)).c_str(),
                               run, layout, degree)
      ->UseManualTime()
      ->Unit(benchmark::kNanosecond);
}

bool add_all()
{
  const std::vector<std::pair<std::string, Run>> steps{
      {"split", split},   {"restrict", restrict},         {"bounds", bounds},
      {"linear", linear}, {"precondition", precondition}, {"reduction", reduction},
      {"dense", dense},   {"derivatives", derivatives},   {"image", image}};
  for (const auto& [name, run] : steps) {
    const int largest = run == precondition ? 2 : 10;   // linear rows do not know the degree
    for (int n : {2, 3, 4})
      for (int degree = 2; degree <= largest; ++degree)
        add(name + "/dense", run, make_dense(n, degree), degree);
    if (run != dense)   // where it may pay
      for (int degree = 2; degree <= largest; ++degree)
        add(name + "/curves", run, make_curves(degree), degree);
  }
  return true;
}

[[maybe_unused]] const bool is_added = add_all();

} // namespace
