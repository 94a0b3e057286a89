// SPDX-License-Identifier: Apache-2.0


namespace compared_0 {
static void run() { int a = 1, b = 2, c = 3, d = 4, i = 0, n = 3; std::vector<int> v{1, 2};
 num("a", a < b && c > (d)); num("b", a < b > (c)); if (a < b && c > (d - 2)) show("then"); else show("else"); if (i < (int)v.size() && n > (2)) show("then2"); else show("else2"); bool t = i < n and n > (4); num("t", t); num("u", i < n || n > (4)); num("w", (i < n) > (0)); num("x", i < 3 && n > (2)); while (i < n && n > (2)) { ++i; } num("i", i); num("y", a < b + 1 && c > (d)); }
}  // namespace compared_0

namespace compared_1 {
struct Q { int count_ = 1, max_ = 3; int left = 2; bool more() { return count_ < max_ && left > (0); } void go() { while (count_ < max_ && left > (0)) { num("q", count_); ++count_; } if (count_ < max_ || left > (1)) show("still"); else show("done"); if (!(count_ < max_ && left > (0))) show("over"); } };
static int total = 5; static const int most = 7;
static void run() { Q q; num("a1", q.more()); q.go(); num("b1", total < most && most > (6)); for (int i = 0; i < most && total > (2); ++i) { num("c", i); --total; } int k = 1; k < most && k > (0) ? show("yes") : show("no"); bool r = (k < most && k > (0)); num("r1", r); if (k < most && k > (0) && total > (1)) show("and"); else show("nand"); }
}  // namespace compared_1

namespace compared_2 {
static constexpr int two = 2; static int two_f(int x) { return x; } template <bool B> int flag(int a) { return B ? a : -a; }
static void run() { int d = 4; num("c2", flag<two && two>(d)); num("h2", two < d && d > (two)); num("j2", two < two_f(3) && d > (5)); }
}  // namespace compared_2

static void run() {compared_0::run(); compared_1::run(); compared_2::run();}
