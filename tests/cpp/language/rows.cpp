// SPDX-License-Identifier: Apache-2.0

// Braces in braces: one row of an array, or one element of a vector, that is made of several values.
struct Row
{
  std::string a, b;
};
struct Named
{
  std::string name;
  std::vector<Row> rows;
  int numbers[1];
};
struct Fields
{
  Row rows[1] = {{"h0", "h1"}};
  std::vector<Row> braces{{"f0", "f1"}};
  std::vector<Row> equals = {{"g0", "g1"}};
  std::array<Row, 1> standard{{{"s0", "s1"}}};
  std::vector<Row> made;
  int ends[2];
  Fields() : made{{"c0", "c1"}}, ends{7, 8} {}
};

static const Row table[] = {{"t0", "t1"}};
static const Row two[] = {{"u0", "u1"}, {"w0", "w1"}};
static const char * const pairs[][2] = {{"p0", "p1"}};
static const std::vector<Row> listed = {{"v0", "v1"}};
static const std::vector<std::pair<std::string, int>> counted{{"n", 1}};

static std::vector<Row> give() {return {{"r0", "r1"}};}
static void take(const std::vector<Row> & rows) {show("taken_" + rows[0].a + rows[0].b + std::to_string(rows.size()));}

static void run()
{
  for (const auto & row : table) {show("table_" + row.a + row.b);}
  for (const auto & row : two) {show("two_" + row.a + row.b);}
  for (const auto & pair : pairs) {show(std::string("pairs_") + pair[0] + pair[1]);}
  for (const auto & row : listed) {show("listed_" + row.a + row.b);}
  for (const auto & [name, count] : counted) {num("counted_" + name, count);}
  num("rows", sizeof(table) / sizeof(table[0]));

  Fields f;
  show("fields_" + f.rows[0].b + f.braces[0].b + f.equals[0].b + f.standard[0].b + f.made[0].b);
  num("ends", f.ends[1]);
  Named n{"named", {{"q0", "q1"}}, {3}};
  show(n.name + "_" + n.rows[0].b + std::to_string(n.rows.size()) + std::to_string(n.numbers[0]));
  show("given_" + give()[0].b);
  take({{"a", "b"}});

  Row row[1] = {{"l0", "l1"}};
  show("row_" + row[0].b);
  int matrix[1][2] = {{5, 6}};
  num("matrix", matrix[0][1]);
  std::vector<int> lists[1] = {{1, 2}};
  num("lists", lists[0].size());
  std::vector<std::vector<int>> nested{{1, 2}};
  num("nested", nested.size());
  std::vector<std::vector<int>> copied{{{1, 2}, {3}}};
  num("copied", copied.size());
  std::vector<std::string> one{{"s0"}};
  num("one", one.size());
  std::vector<std::tuple<std::string, int>> tuples{{"t", 4}};
  num("tuples", std::get<1>(tuples[0]));
  std::vector<Row> assigned;
  assigned = {{"x0", "x1"}};
  show("assigned_" + assigned[0].b);
  auto led = new std::vector<Row>{{"y0", "y1"}};
  show("led_" + (*led)[0].b);
}
