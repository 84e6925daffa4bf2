// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/IO/read_minibex.h>
#include <CGAL/Spline_constraints_d/IO/write_minibex.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace read_minibex_test {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Minibex_system;
using SC::Parse_error;
using SC::Power_polynomial;
using SC::Relation;

namespace {

Minibex_system read(const std::string& content)
{
  std::istringstream in(content);
  return SC::read_minibex(in, "test.bch");
}

// A system with unknowns x, y and an array z[3] around some constraints.
std::string with_constraints(const std::string& constraints)
{
  return "Variables\nx in [-2,2], y in [0,1]; z[3] in [-1,1];\nConstraints\n" + constraints + "\nend\n";
}

Power_polynomial function(const std::string& expression)
{
  return read(with_constraints(expression + " = 0;")).constraints.at(0).function;
}

Power_polynomial unknown(int index) { return Power_polynomial::variable(index); }
Exact_rational ratio(int numerator, int denominator) { return Exact_rational(numerator) / Exact_rational(denominator); }

struct Place
{
  int line, column;
  std::string text;
};

// Reading must fail at the place, with a message that contains `part`.
void expect_error(const std::string& content, const Place& place, const std::string& part)
{
  try {
    read(content);
    ADD_FAILURE() << "no error in: " << content.substr(0, 200);
  } catch (const Parse_error& error) {
    EXPECT_EQ(error.line(), place.line) << error.what();
    EXPECT_EQ(error.column(), place.column) << error.what();
    EXPECT_EQ(error.text(), place.text) << error.what();
    EXPECT_EQ(error.file(), "test.bch");
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what())
                  .find("test.bch:" + std::to_string(place.line) + ':' + std::to_string(place.column) + ": "),
              0u)
        << error.what();
  }
}

// Reading an expression must fail on line 4, the one of the constraints.
void expect_expression_error(const std::string& expression, int column, const std::string& text,
                             const std::string& part)
{
  expect_error(with_constraints(expression), {4, column, text}, part);
}

const Power_polynomial x = unknown(0), y = unknown(1), z1 = unknown(2), z2 = unknown(3), z3 = unknown(4);

TEST(Read_minibex, a_whole_system)
{
  const Minibex_system system = read("// a circle and a line\n"
                                     "Constants\n  r = 3/2; s in [2,2];\n"
                                     "Variables\n  x in [-1e8, 1e8], y in [-r, 2*r];\n  z[3] in [0, 1];\n"
                                     "Constraints\n"
                                     "  x^2 + 7./48*sqr(y) - s*z(1) = 0; /* two\n lines */\n"
                                     "  (x - 1)*z[0]^3 <= .5e-3;\n"
                                     "  x < y; x > y; x >= z(3)\n"
                                     "end");
  EXPECT_EQ(system.names, (std::vector<std::string>{"x", "y", "z(1)", "z(2)", "z(3)"}));
  ASSERT_EQ(system.domains.size(), 5u);
  EXPECT_EQ(system.domains[0].first, Exact_rational(-100000000));
  EXPECT_EQ(system.domains[1].first, ratio(-3, 2));
  EXPECT_EQ(system.domains[1].second, Exact_rational(3));
  EXPECT_EQ(system.domains[4].second, Exact_rational(1));
  ASSERT_EQ(system.constraints.size(), 5u);
  EXPECT_EQ(system.constraints[0].function, x * x + ratio(7, 48) * y * y - 2 * z1);
  EXPECT_EQ(system.constraints[0].relation, Relation::EQUAL);
  EXPECT_EQ(system.constraints[0].line, 8);
  EXPECT_EQ(system.constraints[1].function, (x - 1) * pow(z1, 3) - ratio(1, 2000));
  EXPECT_EQ(system.constraints[1].relation, Relation::LESS_EQUAL);
  EXPECT_EQ(system.constraints[1].line, 10);
  EXPECT_EQ(system.constraints[2].relation, Relation::LESS);
  EXPECT_EQ(system.constraints[3].relation, Relation::GREATER);
  EXPECT_EQ(system.constraints[4].relation, Relation::GREATER_EQUAL);
  EXPECT_EQ(system.constraints[4].function, x - z3);
}

TEST(Read_minibex, numbers_are_exact)
{
  EXPECT_EQ(function("0.1"), Power_polynomial(ratio(1, 10)));
  EXPECT_EQ(function("7./48"), Power_polynomial(ratio(7, 48)));
  EXPECT_EQ(function(".5"), Power_polynomial(ratio(1, 2)));
  EXPECT_EQ(function("1e-3"), Power_polynomial(ratio(1, 1000)));
  EXPECT_EQ(function("12.50E+2"), Power_polynomial(1250));
  EXPECT_EQ(function("1e8"), Power_polynomial(100000000));
  EXPECT_EQ(function("007"), Power_polynomial(7));
  EXPECT_EQ(function("0e5"), Power_polynomial());
  EXPECT_EQ(function("0.00000000000000000000000000001*1e29"), Power_polynomial(1));
  EXPECT_EQ(function("356.474947137148") * 1000000000 * 1000, Power_polynomial(356474947137148L));
  EXPECT_EQ(function("1e-4000*1e4000"), Power_polynomial(1));
}

TEST(Read_minibex, the_rounding_mode_does_not_matter)
{
  const int mode = std::fegetround();
  for (int other : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(other);
    const Power_polynomial p = function("0.1*x - 1e-30*y^2/7 + 12345678901234567890123/3");
    std::fesetround(mode);
    EXPECT_EQ(p * 3 * 7, function("2.1*x - 3e-30*y^2 + 7*12345678901234567890123"));
  }
}

TEST(Read_minibex, precedence)
{
  EXPECT_EQ(function("-x^2"), -x * x);
  EXPECT_EQ(function("--x^2"), x * x);
  EXPECT_EQ(function("2*-x^2*y"), -2 * x * x * y);
  EXPECT_EQ(function("-x*y + x"), x - x * y);
  EXPECT_EQ(function("x - y - z(1)"), x - y - z1);
  EXPECT_EQ(function("x - (y - z(1))"), x - y + z1);
  EXPECT_EQ(function("12/2/3*x"), 2 * x);
  EXPECT_EQ(function("2^3^2"), Power_polynomial(64));
  EXPECT_EQ(function("2^-3"), Power_polynomial(ratio(1, 8)));
  EXPECT_EQ(function("x/-3 + y"), y - x / 3);
  EXPECT_EQ(function("2*x^2^2"), 2 * pow(x, 4));
  EXPECT_EQ(function("x^(1+1)"), x * x);
  EXPECT_EQ(function("x^(4/2)"), x * x);
  EXPECT_EQ(function("3 - 6*-(x + y)/(1+2)"), 3 + 2 * (x + y));
  EXPECT_EQ(function("sqr(x + y)"), x * x + 2 * x * y + y * y);
  EXPECT_EQ(function("z(2)*z[2]"), z2 * z3);
  EXPECT_EQ(function("z(1+1)"), z2);
  EXPECT_EQ(function("x^0"), Power_polynomial(1));
  EXPECT_EQ(read(with_constraints("x = y")).constraints[0].function, x - y);
}

TEST(Read_minibex, declarations)
{
  const Minibex_system system =
      read("VARIABLES a[2] in ([0,1]; [-1/3,2]);sqr in[0,0];_b1 in [1-2^2,1e-2];CONSTRAINTS a(2)=sqr END");
  EXPECT_EQ(system.names, (std::vector<std::string>{"a(1)", "a(2)", "sqr", "_b1"}));
  EXPECT_EQ(system.domains[1].first, ratio(-1, 3));
  EXPECT_EQ(system.domains[2].second, Exact_rational(0));
  EXPECT_EQ(system.domains[3].first, Exact_rational(-3));
  EXPECT_EQ(system.domains[3].second, ratio(1, 100));
  EXPECT_EQ(system.constraints[0].function, unknown(1) - unknown(2));
  EXPECT_EQ(read("constants c=2;d=c^2; variables x in [-d,d]; constraints x=c; end").domains[0].second,
            Exact_rational(4));
}

TEST(Read_minibex, numbers_without_brackets)
{
  const Minibex_system system =
      read("Constants a in 0.5; b[2] in (1, [2,2]); c[3] = 4; Variables x in -a; y[2] in (b(2); [0,c(3)]); "
           "Constraints x + a*y(1) = b[0]; end");
  EXPECT_EQ(system.domains[0], std::pair(ratio(-1, 2), ratio(-1, 2)));
  EXPECT_EQ(system.domains[1], std::pair(Exact_rational(2), Exact_rational(2)));
  EXPECT_EQ(system.domains[2].second, Exact_rational(4));
  EXPECT_EQ(system.constraints[0].function, unknown(0) + unknown(1) / 2 - 1);
}

TEST(Read_minibex, loops_and_sums)
{
  const Minibex_system system =
      read("constants c[3] = (1; 1/2; 1/3); variables v[3] in [0,1]; constraints\n"
           "for i = 1:2;\n v(i+1) = i*v(i);\n for k = i:2; v(k) <= v[k] + i end end\n"
           "sum(i = 1:3, c(i)*sum(k = 1:i, v(k)^i)) = 0;\nfor i = -1:-1; v(i+2) = i; end; end");
  const Power_polynomial a = unknown(0), b = unknown(1), c = unknown(2);
  const std::vector<Power_polynomial> expected{
      b - a,     a - b - 1, b - c - 1,
      c - 2 * b, b - c - 2, a + (a * a + b * b) / 2 + (pow(a, 3) + pow(b, 3) + pow(c, 3)) / 3,
      a + 1};
  ASSERT_EQ(system.constraints.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(system.constraints[i].function, expected[i]) << i;
  EXPECT_EQ(system.constraints[4].line, 4);
  expect_expression_error("for i = 2:1; z(i) = 0; end", 9, "2", "an empty range");
  expect_expression_error("for x = 1:2; z(x) = 0; end", 5, "x", "declared already");
  expect_expression_error("for i = 1:4; z(i) = 0; end", 16, "i", "index");
  expect_error(with_constraints("for i = 1:2; z(i) = 0;"), {6, 1, ""}, "expected a number");
  expect_expression_error("for i = 1:2; z(i) = 0; end i = 0;", 28, "i", "unknown name");
  expect_expression_error("sum(i = 1:x, z(i)) = 0;", 11, "x", "end of the range");
  expect_expression_error("sum(i = 1:3, z(i) = 0;", 19, "=", "expected ')'");
}

TEST(Read_minibex, functions_and_extremes)
{
  const std::string functions = "Function f(x, w[3]) s = x^2 + w(1); t = s + c; return t*w[1] end\n"
                                "FUNCTION g(x, w[3]) return f(x, w) - f(1, w); END;\n",
                    variables = "Variables x in [0,1]; z[3] in [0,1];\n",
                    constraints = "Constraints g(2*x, z) = max(min(3, 1/2), c/28, -1); end";
  for (const std::string& content : {"Constants c = 7; " + functions + variables + constraints,
                                     "Constants c = 7; " + variables + functions + constraints})
    EXPECT_EQ(read(content).constraints.at(0).function, (4 * unknown(0) * unknown(0) - 1) * unknown(2) - ratio(1, 2));

  const auto expect_error_of_function = [](const std::string& function, const std::string& call, int column,
                                           const std::string& text, const std::string& part) {
    expect_error("Variables x in [0,1]; z[3] in [0,1]; " + function + "\nConstraints " + call + " = 0; end",
                 {column < 38 ? 2 : 1, column, text}, part);
  };
  expect_error_of_function("Function f(a) return a*x end", "f(x)", 61, "x", "unknown name");
  expect_error_of_function("Function f(a) return f(a) end", "f(x)", 59, "f", "not defined before");
  expect_error_of_function("Function f(a) a = 1; return a end", "f(x)", 52, "a", "declared already");
  expect_error_of_function("Function f(a, a) return a end", "f(x)", 52, "a", "declared already");
  expect_error_of_function("Function f(a, b[a]) return a end", "f(x)", 54, "a", "unknown name");
  expect_error_of_function("Function f(a) a*2 end", "f(x)", 56, "end", "expected 'return'");
  expect_error_of_function("Function f(a) return a", "f(x)", 1, "Constraints", "expected the end of function 'f'");
  expect_error_of_function("Function f(a, b) return a end", "f(x)", 16, ")", "too few arguments");
  expect_error_of_function("Function f(a) return a end", "f(x, x)", 16, ",", "too many arguments");
  expect_error_of_function("Function f(a[2]) return a(1) end", "f(z)", 15, "z", "an array of size 2");
  expect_error_of_function("Function f(a) return a end", "f(z)", 16, ")", "needs an index");
  expect_error_of_function("Function f(a) return 1/a end", "f(x)", 60, "/", "not a constant");
  expect_expression_error("min(x, 1) = 0;", 1, "min", "'min' of unknowns");
  expect_expression_error("max() = 0;", 5, ")", "expected a number");
}

TEST(Read_minibex, line_ends_and_blanks)
{
  for (const std::string& end_of_line : std::vector<std::string>{"\n", "\r\n", "\r"}) {
    const std::string content = "\xEF\xBB\xBFVariables" + end_of_line + "x\tin [0,1];" + end_of_line + end_of_line +
        "Constraints // c" + end_of_line + "x^2=";
    EXPECT_EQ(read(content + "1;end").constraints[0].line, 5);
    expect_error(content + "1;x=?;", {5, 9, "?"}, "unexpected character");
  }
}

TEST(Read_minibex, errors_of_structure)
{
  expect_error("", {1, 1, ""}, "expected 'Variables'");
  expect_error("\n\n  x in [0,1];", {3, 3, "x"}, "expected 'Variables'");
  expect_error("variableS", {1, 1, "variableS"}, "expected 'Variables'");
  expect_error("Variables", {1, 10, ""}, "expected a name");
  expect_error("Variables x in [0,1]", {1, 21, ""}, "expected ',' or ';'");
  expect_error("Variables x in [0,1], Constraints", {1, 23, "Constraints"}, "expected a name");
  expect_error("Variables x in [0,1];", {1, 22, ""}, "expected a name");
  expect_error("Variables x in [0,1]; Constraints end", {1, 35, "end"}, "expected a constraint");
  expect_error("Variables x in [0,1]; Constraints x=0;", {1, 39, ""}, "expected a number, a name");
  expect_error("Variables x in [0,1]; Constraints x=0; end x", {1, 44, "x"}, "after 'end'");
  expect_error("Variables x in [0,1]; Function f(x) return x; end minimize x;", {1, 51, "minimize"},
               "not in the polynomial subset");
  expect_error("Variables x in [0,1]; minimize x; constraints x=0; end", {1, 23, "minimize"},
               "not in the polynomial subset");
  expect_error("Variables x in [0,1]; Constants a=1;", {1, 23, "Constants"}, "must come first");
  expect_error("/* x\n  Variables", {1, 1, "/*"}, "not closed");
}

TEST(Read_minibex, errors_of_declarations)
{
  expect_error("Variables x;", {1, 12, ";"}, "the domain of 'x' is missing");
  expect_error("Variables x in [-oo,oo];", {1, 18, "oo"}, "the domain of 'x' must be finite");
  expect_error("Variables x in [1,0];", {1, 16, "["}, "the domain of 'x' is empty");
  expect_error("Variables x in [0,1], x in [0,1];", {1, 23, "x"}, "declared already");
  expect_error("Variables sin in [0,1];", {1, 11, "sin"}, "reserved");
  expect_error("Variables x in [0,x];", {1, 19, "x"}, "unknown name");
  expect_error("Variables x in [0,1]; y in [0,x];", {1, 31, "x"}, "expected a constant");
  expect_error("Variables x[0] in [0,1];", {1, 13, "0"}, "size of the array");
  expect_error("Variables x[1.5] in [0,1];", {1, 13, "1.5"}, "constant integer");
  expect_error("Variables x[1000000000] in [0,1];", {1, 13, "1000000000"}, "size of the array");
  expect_error("Variables x[65000] in [0,1]; y[65000] in [0,1];", {1, 30, "y"}, "unknowns");
  expect_error("Variables x[2][2] in [0,1];", {1, 15, "["}, "matrices");
  expect_error("Variables x[2] in ([0,1]);", {1, 19, "("}, "too few domains");
  expect_error("Variables x[2] in ([0,1];[0,1];[0,1]);", {1, 19, "("}, "too many domains");
  expect_error("Constants a in [1,2];", {1, 16, "["}, "is an interval");
  expect_error("Constants a[2][2] = (1;2);", {1, 15, "["}, "matrices");
  expect_error("Constants a[2] = (1;2;3);", {1, 18, "("}, "2 elements, not 3");
  expect_error("Constants a[2] in (1;[2,3]);", {1, 22, "["}, "is an interval");
  expect_error("Constants a = 1/0;", {1, 16, "/"}, "division by zero");
  expect_error("Constants a = 1; Variables a in [0,1];", {1, 28, "a"}, "declared already");
}

TEST(Read_minibex, errors_of_expressions)
{
  expect_expression_error("x + = 0;", 5, "=", "expected a number");
  expect_expression_error("x + t = 0;", 5, "t", "unknown name");
  expect_expression_error("2x = 0;", 2, "x", "expected an operator");
  expect_expression_error("x;", 2, ";", "expected an operator");
  expect_expression_error("x = 0 = y;", 7, "=", "expected an operator");
  expect_expression_error("x == 0;", 4, "=", "expected a number");
  expect_expression_error("(x = 0);", 4, "=", "in parentheses");
  expect_expression_error("(x + 1 = 0;", 8, "=", "expected ')'");
  expect_expression_error("x) = 0;", 2, ")", "expected an operator");
  expect_expression_error("1/x = 0;", 2, "/", "not a constant");
  expect_expression_error("x/(1-1) = 0;", 2, "/", "division by zero");
  expect_expression_error("x/(y-y) = 0;", 2, "/", "division by zero");
  expect_expression_error("x^y = 0;", 3, "y", "exponent");
  expect_expression_error("x^0.5 = 0;", 3, "0.5", "exponent");
  expect_expression_error("x^-1 = 0;", 2, "^", "negative exponent");
  expect_expression_error("0^-1 = 0;", 2, "^", "division by zero");
  expect_expression_error("1/-2*3 = x;", 3, "-", "write parentheses");
  expect_expression_error("2^-2*x = 0;", 3, "-", "write parentheses");
  expect_expression_error("sin(x) = 0;", 1, "sin", "'sin' is not in the polynomial subset");
  expect_expression_error("pi*x = 0;", 1, "pi", "'pi' is not in the polynomial subset");
  expect_expression_error("x < oo;", 5, "oo", "infinity");
  expect_expression_error("x in [0,1];", 3, "in", "expected an operator");
  expect_expression_error("z = 0;", 3, "=", "needs an index");
  expect_expression_error("z(0) = 0;", 3, "0", "index");
  expect_expression_error("z(4) = 0;", 3, "4", "index");
  expect_expression_error("z[3] = 0;", 3, "3", "index");
  expect_expression_error("z(x) = 0;", 3, "x", "index");
  expect_expression_error("x(1) = 0;", 2, "(", "not an array");
  expect_expression_error("x = 1e;", 5, "1e", "no digits");
  expect_expression_error("x = 1e+;", 5, "1e+", "no digits");
  expect_expression_error("x = 1.2.3;", 8, ".3", "expected an operator");
  expect_expression_error("x = \x01;", 5, "\x01", "'\\x01'");
  expect_expression_error("x = {1};", 5, "{", "unexpected character");
}

TEST(Read_minibex, absurd_input_is_refused_quickly)
{
  const auto start = std::chrono::steady_clock::now();
  expect_expression_error("x = 1e999999999;", 5, "1e999999999", "digits");
  expect_expression_error("x = 1e-99999999999999999999999;", 5, "1e-99999999999999999999999", "digits");
  expect_expression_error("x = 0." + std::string(100000, '0') + "1;", 5, ("0." + std::string(58, '0')), "digits");
  expect_expression_error("x^1000000000 = 0;", 3, "1000000000", "exponent");
  expect_expression_error("x^99999999999999999999 = 0;", 3, "99999999999999999999", "exponent");
  expect_expression_error("x^100000 = 0;", 2, "^", "total degree");
  expect_expression_error("2^1000000 = x;", 2, "^", "bits");
  expect_expression_error("(((9^999)^999)^999)^999 = x;", 10, "^", "bits");
  expect_expression_error("(x + y + z(1) + z(2) + z(3))^1000 = 0;", 29, "^", "work");
  expect_expression_error("((((x+1)^9+y)^9+z(1))^9+z(2))^9 = 0;", 22, "^", "work");
  expect_expression_error(std::string(100000, '(') + "x", 201, "(", "nested");
  expect_expression_error("x" + std::string(200, '^') + "2", 3, "^", "expected a number");
  expect_expression_error("sum(i=1:1000000,1) = x;", 18, ")", "work");
  expect_expression_error("for i=1:1000; for j=1:1000; for k=1:1000; x=i*j*k; end end end", 48, "*", "work");
  std::string functions = "Function f0(a) return a end\n";
  for (int i = 1; i < 100; ++i)
    functions += "Function f" + std::to_string(i) + "(a) return f" + std::to_string(i - 1) + "(f" +
        std::to_string(i - 1) + "(a)) end\n";
  EXPECT_THROW(read(functions + with_constraints("f99(x) = 0;")), Parse_error);
  // Long but harmless: linear time.
  EXPECT_EQ(function(std::string(100001, '-') + "x"), -x);
  std::string sum = "x";
  for (int i = 0; i < 50000; ++i)
    sum += " + y - 0.5*y*2";
  EXPECT_EQ(function(sum), x);
  // Many large numbers without a common denominator.
  std::string fractions = "x";
  for (int i = 0; i < 2000; ++i)
    fractions += " + 1/" + std::to_string(2 * i + 3) + "^1000";
  EXPECT_THROW(function(fractions), Parse_error);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

// With elementary functions: values of polynomials, which are made once.
TEST(Read_minibex, elementary_functions)
{
  const auto read_all = [](const std::string& content) {
    std::istringstream in(content);
    return SC::read_minibex(in, "elementary", SC::Minibex_subset::ELEMENTARY);
  };
  const auto of = [&](const std::string& expression) {
    const Minibex_system system = read_all(with_constraints(expression + " = 0;"));
    return std::pair(system.constraints.at(0).function, system.values);
  };
  const auto text = [&](const std::string& expression) {
    const auto [function, values] = of(expression);
    const std::vector<std::string> names{"x", "y", "z(1)", "z(2)", "z(3)"};
    return values.text(function, names);
  };
  EXPECT_EQ(text("exp(x) - 2*x*exp(x)"), "-2*x*exp(x) + exp(x)");
  EXPECT_EQ(of("exp(x) - 2*x*exp(x)").second.all().size(), 1u);
  EXPECT_EQ(text("log(x + y)"), text("ln(y + x)"));
  EXPECT_EQ(text("sin(cos(x)^2)"), "sin(cos(x)^2)");
  EXPECT_EQ(text("1/x^2"), text("x^-2"));
  EXPECT_EQ(text("x/(y + 1)"), "x*(1/(1 + y))");
  EXPECT_EQ(text("x^(1/3)"), "((x)^(1/3))");
  EXPECT_EQ(text("x^0.5"), text("sqrt(x)"));
  EXPECT_EQ(text("x^y"), text("exp(y*ln(x))"));
  EXPECT_EQ(text("-x^-1"), text("0 - 1/x"));
  EXPECT_EQ(text("2^0.5*sqrt(2) + x"), text("sqrt(2)^2 + x"));
  EXPECT_EQ(text("exp(0) + ln(1) + sqrt(4) + cos(0)"), "4");
  EXPECT_EQ(text("sqr(abs(x))"), "abs(x)^2");
  for (const std::string name : {"asin", "acos", "atan", "sinh", "cosh", "tanh", "tan"})
    EXPECT_EQ(text(name + "(x)"), name + "(x)");

  // ends of domains are rounded outwards; values that served for nothing else are left out
  const Minibex_system angle = read_all("Constants a = 2*pi; Variables x in [-a, pi]; Constraints x^2 = 1; end");
  EXPECT_TRUE(angle.values.all().empty());
  EXPECT_LT(angle.domains[0].first, Exact_rational(-0x1.921fb54442d18p+2));
  EXPECT_GT(angle.domains[0].first, Exact_rational(-6.28318530717961));
  EXPECT_GT(angle.domains[0].second, Exact_rational(0x1.921fb54442d18p+1));
  EXPECT_LT(angle.domains[0].second, Exact_rational(3.14159265358981));
  EXPECT_EQ(read_all("Constants a = pi; Variables x in [0, 1]; Constraints a*x = 1; end").values.all().size(), 1u);

  const Minibex_system system = read_all("Variables x in [0,1]; y in [0,1]; Constraints exp(x)/y = 2^x; x*sin(y/3) < "
                                         "y^(2/3) + atan(1); end");
  std::ostringstream out;
  SC::write_minibex(out, system);
  const Minibex_system copy = read_all(out.str());
  ASSERT_EQ(copy.constraints.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(copy.values.text(copy.constraints[i].function, copy.names),
              system.values.text(system.constraints[i].function, system.names));

  const auto expect_elementary_error = [&](const std::string& expression, int column, const std::string& part) {
    try {
      read_all(with_constraints(expression));
      ADD_FAILURE() << "no error for " << expression;
    } catch (const Parse_error& error) {
      EXPECT_EQ(error.line(), 4);
      EXPECT_EQ(error.column(), column) << expression;
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  expect_elementary_error("atan2(x, y) = 0;", 1, "'atan2' is not in the subset of Minibex");
  expect_elementary_error("ln(-1) = x;", 1, "not defined");
  expect_elementary_error("x/(y - y) = 0;", 2, "division by zero");
  expect_elementary_error("(-2)^(1/3) = x;", 5, "not defined");
  expect_elementary_error("sin x = 0;", 5, "expected '('");
  expect_elementary_error("sin(x, y) = 0;", 6, "expected ')'");
  expect_elementary_error("z(pi) = 0;", 3, "index");
  expect_elementary_error("min(pi, 3) = x;", 1, "'min'");
  expect_elementary_error("x^1000000000 = 0;", 3, "exponent");
  expect_elementary_error("x^(1/3)^(1000000000) = 0;", 9, "exponent");
}

TEST(Read_minibex, files)
{
  const std::string path = testing::TempDir() + "spline_constraints_read_minibex.bch";
  std::ofstream(path) << with_constraints("x = y;");
  const Minibex_system system = SC::read_minibex(path);
  std::remove(path.c_str());
  ASSERT_EQ(system.constraints.size(), 1u);
  EXPECT_EQ(system.constraints[0].function, x - y);
  for (const std::string& missing : std::vector<std::string>{path, testing::TempDir()}) {
    try {
      SC::read_minibex(missing);
      ADD_FAILURE() << "no error for " << missing;
    } catch (const Parse_error& error) {
      EXPECT_EQ(error.file(), missing);
      EXPECT_EQ(error.line(), 0);
      EXPECT_EQ(std::string(error.what()).find(missing + ": cannot be "), 0u);
    }
  }
}

TEST(Read_minibex, the_systems_of_the_examples)
{
  const auto folder =
      std::filesystem::path(__FILE__).parent_path() / ".." / ".." / ".." / "examples" / "Spline_constraints_d" / "data";
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".bch")
      continue;
    ++files;
    std::string header;
    std::ifstream in(entry.path());
    std::getline(in, header);
    EXPECT_EQ(header.find("// real roots: "), 0u) << entry.path();
    const Minibex_system system = SC::read_minibex(entry.path().string());
    EXPECT_EQ(system.names.size(), system.constraints.size()) << entry.path();
    for (const auto& constraint : system.constraints)
      EXPECT_GT(constraint.function.total_degree(), 0) << entry.path();
  }
  EXPECT_GE(files, 10);
}

TEST(Write_minibex, round_trip)
{
  const Minibex_system system =
      read("Constants r = 1/3; Variables x in [-r, 1e-7]; a[2] in ([0,1]; [-1.5,2]); y in [0,1];\n"
           "Constraints (x - r*a(1) + 2^70)^3 = y; a(2) < 1e-30; -x >= y; x > 0; 0 = 0; x <= 1; end");
  ASSERT_EQ(system.constraints.size(), 6u);
  std::ostringstream out;
  SC::write_minibex(out, system);
  const Minibex_system copy = read(out.str());
  EXPECT_EQ(copy.names, system.names);
  EXPECT_EQ(copy.domains, system.domains);
  ASSERT_EQ(copy.constraints.size(), system.constraints.size());
  for (std::size_t i = 0; i < copy.constraints.size(); ++i) {
    EXPECT_EQ(copy.constraints[i].function, system.constraints[i].function);
    EXPECT_EQ(copy.constraints[i].relation, system.constraints[i].relation);
  }
}

TEST(Write_minibex, bad_systems_are_refused)
{
  const Minibex_system good = read(with_constraints("x = y;"));
  std::ostringstream out;
  EXPECT_THROW(SC::write_minibex(out, {}), SC::Invalid_input);
  Minibex_system bad = good;
  bad.names[1] = "a b";
  EXPECT_THROW(SC::write_minibex(out, bad), SC::Invalid_input);
  bad.names[1] = "a(2)";
  EXPECT_THROW(SC::write_minibex(out, bad), SC::Invalid_input);
  bad = good;
  bad.domains.pop_back();
  EXPECT_THROW(SC::write_minibex(out, bad), SC::Invalid_input);
  bad = good;
  bad.constraints[0].function = unknown(17);
  EXPECT_THROW(SC::write_minibex(out, bad), SC::Invalid_input);
  bad = good;
  bad.constraints[0].relation = SC::Relation::NOT_EQUAL;
  EXPECT_THROW(SC::write_minibex(out, bad), SC::Invalid_input);
  EXPECT_EQ(out.str(), "");
}

} // namespace

} // namespace read_minibex_test
