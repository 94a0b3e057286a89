// SPDX-License-Identifier: Apache-2.0
// What is written to arrays of characters, through pointers into them, and what is made of them before and after.
#include <any>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>

static char global_name[8] = "glob";
struct Holder { char * p; };
struct Rec { char name[8] = "rec"; int n = 0; };
struct Rec2 { std::string s; char * p = nullptr; };
template<typename T> void tmpl(T p) { *p = 'x'; }
template<typename T> void tmplref(T & p) { p[0] = 'x'; }
static void fill_it(char * out) { strcpy(out, "filled"); }
static void put_first(char * out) { *out = 'x'; }
static char * returned(char * in) { return in + 1; }

static char * kept() { static char s[8] = "abc"; return s; }
static char * of_namespace() { return global_name; }

static void run()
{
  { char name[16] = "abc"; char * p = name; *p = 'x'; show(std::string("c1_") + name); }
  { char name[16] = "abc"; char * p = name; p[0] = 'x'; show(std::string("c2_") + name); }
  { char name[16] = "abc"; char * p = name; strcpy(p, "new"); show(std::string("c3_") + name); }
  { char name[16] = "abc"; char * p = name; snprintf(p, 16, "c%d", 4); show(std::string("c4_") + name); }
  { char name[16] = "abc"; auto p = name; *p = 'x'; show(std::string("c5_") + name); }
  { char name[16] = "abc"; auto * p = name; p[1] = 'x'; show(std::string("c6_") + name); }
  { char name[16] = "abc"; char * p; p = name; *p = 'x'; show(std::string("c7_") + name); }
  { char name[16] = "abc"; char * p = nullptr; p = name + 1; *p = 'x'; show(std::string("c8_") + name); }
  { char name[16] = "abc"; char * p = &name[1]; *p++ = 'x'; *p++ = 'y'; *p = '\0'; show(std::string("c9_") + name); }
  { char name[16] = "abc"; fill_it(name); show(std::string("c10_") + name); }
  { char name[16] = "abc"; put_first(&name[0]); show(std::string("c11_") + name); }
  { char name[16] = "abc"; put_first(name + 2); show(std::string("c12_") + name); }
  { char name[16] = "abc"; strcat(name, "d"); char * q = name + strlen(name); strcpy(q, "ef"); show(std::string("c13_") + name); }
  { std::string s = "abc"; char * p = &s[0]; *p = 'x'; show(std::string("c15_") + s); }
  { std::string s = "abc"; char * p = s.data(); p[1] = 'x'; show(std::string("c16_") + s); }
  { char name[16] = "abcdef"; std::replace(name, name + 6, 'c', '_'); show(std::string("c17_") + name); }
  { char name[16] = "abcdef"; char * c = strchr(name, 'c'); *c = '_'; show(std::string("c18_") + name); }
  { char name[16] = "a/b/c"; for (char * p = name; *p; ++p) { if (*p == '/') { *p = '_'; } } show(std::string("c19_") + name); }
  { char name[16] = "abc"; char (&r)[16] = name; r[0] = 'x'; show(std::string("c20_") + name); }
  { char name[16] = "abc"; char & r = name[0]; r = 'x'; show(std::string("c21_") + name); }
  { char name[16] = "abc"; char * p = returned(name); *p = 'x'; show(std::string("c22_") + name); }
  { char name[2][8] = {"ab", "cd"}; char * p = name[1]; *p = 'x'; show(std::string("c23_") + name[1]); }
  { char * p = new char[8]; strcpy(p, "new"); char * q = p; q[0] = 'x'; show(std::string("c24_") + p); }
  { char * p = strdup("abc"); char * q = p; q[0] = 'x'; show(std::string("c25_") + p); }
  { char name[16] = "abc"; std::string copy = name; char * p = name; *p = 'x'; show(std::string("c26_") + copy); show(std::string("c26_") + name); }
  { char name[16] = "abc"; std::strncpy(name + 3, "defgh", 2); show(std::string("c27_") + name); }
  { char name[16] = "abc"; Holder h{name}; h.p[0] = 'x'; show(std::string("c28_") + name); }
  { char name[16] = "abc"; auto l = [&name]() { name[0] = 'x'; }; l(); show(std::string("c29_") + name); }
  { char name[16] = "abc"; auto l = [](char * q) { *q = 'x'; }; l(name); show(std::string("c30_") + name); }
  { char name[16] = "abc"; sprintf(name + strlen(name), "_%02d", 7); show(std::string("c31_") + name); }
  { char name[16] = "abc"; char * const p = name; *(p + 1) = 'x'; show(std::string("c32_") + name); }
  { char name[16] = "abc"; *name = 'x'; *(name + 1) = 'y'; show(std::string("c33_") + name); }
  { char name[16] = "abc"; char * p = (char *)name; *p = 'x'; show(std::string("c34_") + name); }
  { char name[16] = "abc"; char * p = static_cast<char *>(name); *p = 'x'; show(std::string("c35_") + name); }
  { char name[16] = "abc"; unsigned char * p = reinterpret_cast<unsigned char *>(name); *p = 'x'; show(std::string("c36_") + name); }
  { char name[16] = "abc"; char * p = name; char * q = p; *q = 'x'; show(std::string("c37_") + p); show(std::string("c37_") + name); }
  { char name[16] = "abc"; char * p = name; std::swap(p[0], p[2]); show(std::string("c38_") + name); }
  { char name[16] = "abc"; std::reverse(name, name + 3); show(std::string("c39_") + name); }
  { char name[16] = "abc"; std::transform(name, name + 3, name, [](char c) { return (char)std::toupper(c); }); show(std::string("c41_") + name); }
  { char name[16] = "abc"; for (char & c : name) { if (c == 'b') { c = 'x'; } } show(std::string("c42_") + name); }
  { static char g[8] = "abc"; char * p = g; *p = 'x'; show(std::string("c43_") + g); }
  { char * p = global_name; *p = 'x'; show(std::string("c44_") + global_name); }
  { char name[16] = {'a', 'b', 'c', 0}; char * p = name; *p = 'x'; show(std::string("c45_") + name); }
  { char name[16] = {}; char * p = name; p[0] = 'q'; p[1] = 0; show(std::string("c46_") + name); }
  { char name[16] = "abc"; char * ps[] = {name}; ps[0][0] = 'x'; show(std::string("c47_") + name); }
  { char name[16] = "abc"; std::fill(name, name + 2, 'z'); show(std::string("c48_") + name); }
  { char name[16] = "abc"; const char * c = name; name[0] = 'x'; show(std::string("c49_") + c); }
  { char name[16] = "abc"; char * p = name; ++*p; show(std::string("c50_") + name); }
  { auto p = global_name; *p = 'x'; show(std::string("c60_") + global_name); }
  { strcpy(global_name + 2, "_z"); show(std::string("c61_") + global_name); }
  { std::vector<Rec> v(2); strcpy(v[1].name, "one"); char * p = v[1].name; p[0] = 'x'; show(std::string("c71_") + v[1].name); }
  { char a[8] = "abc"; auto l = [a]() mutable { a[0] = 'x'; return std::string(a); }; show(std::string("c72_") + (l())); show(std::string("c72_") + a); }
  { char a[8] = "abc"; auto l = [p = &a[0]]() { *p = 'x'; }; l(); show(std::string("c73_") + a); }
  { char a[8] = "abc"; std::string s = a; s += "z"; char * p = a; *p = 'x'; show(std::string("c74_") + s); show(std::string("c74_") + a); }
  { char name[16] = "ab"; char * q = name; while (*q) { q++; } *q++ = 'c'; *q = 0; show(std::string("c75_") + name); }
  { char name[16] = "abc"; std::memset(name, 0, sizeof(name)); strcpy(name, "q"); show(std::string("c76_") + name); }
  { char name[16]; memset(name, 0, 16); strncpy(name, "hello", 15); show(std::string("c77_") + name); }
  { char name[3][8]; strcpy(name[0], "zero"); strcpy(name[1] + 0, "one"); auto p = name[1]; *p = 'x'; show(std::string("c78_") + name[0]); show(std::string("c78_") + name[1]); }
  { char * argvv[2]; char a[8] = "abc"; argvv[0] = a; *argvv[0] = 'x'; show(std::string("c79_") + a); }
  { char name[16] = "abc"; std::string s; s = name; show(std::string("c80_") + s); s.assign(name); show(std::string("c80_") + (s + "2")); std::vector<std::string> v{name, name}; show(std::string("c80_") + (v[1] + "3")); }
  { char name[16] = "abc"; for (size_t i = 0; i < strlen(name); i++) { name[i] = toupper(name[i]); } show(std::string("c81_") + name); }
  { char name[16] = "abc"; const std::string t = std::string("p_") + name + "_q"; show(std::string("c82_") + t); std::ostringstream o; o << "n" << name; show(std::string("c82_") + (o.str())); }
  { char name[16] = "abc"; if (name == std::string("abc")) { show(std::string("c83_") + ("eq")); } else { show(std::string("c83_") + ("ne")); } if (std::string("abc") == name) { show(std::string("c83_") + ("eq2")); } if (!strcmp(name, "abc")) { show(std::string("c83_") + ("eq3")); } }
  { std::array<char, 8> n{}; snprintf(n.data(), n.size(), "a%d", 1); show(std::string("c84_") + (n.data())); std::string s("q"); s += n.data(); show(std::string("c84_") + s); }
  { char b[32]; std::vector<std::string> v(3); for (int i = 0; i < 3; i++) { snprintf(b, 32, "n%d", i); v[i] = b; } for (auto & s : v) { show(std::string("c85_") + s); } }
  { char b[32] = "one"; std::string s; s = b; strcpy(b, "two"); show(std::string("c86_") + s); show(std::string("c86_") + b); }
  { char b[32] = "one"; std::map<std::string, std::string> m; m["k"] = b; m[b] = "q"; strcpy(b, "two"); show(std::string("c87_") + (m["k"])); show(std::string("c87_") + (m["one"])); }
  { char b[32] = "one"; std_msgs::msg::String m; m.data = b; strcpy(b, "two"); show(std::string("c88_") + m.data); }
  { char b[32] = "one"; std::string s; std::string * q = &s; *q = b; strcpy(b, "two"); show(std::string("c90_") + s); }
  { char b[32] = "one"; char * p = strdup("zz"); p = b; *p = 'x'; show(std::string("c91_") + b); }
  { char b[32] = "one"; std::string s; std::string & r = s; r = b; strcpy(b, "two"); show(std::string("c92_") + s); }
  { char b[32] = "one"; Rec2 r; r.s = b; r.p = b; strcpy(b, "two"); show(std::string("c93_") + r.s); show(std::string("c93_") + (std::string(r.p) + "p")); }
  { char b[32] = "one"; auto l = [&]() -> std::string { return b; }; auto s = l(); strcpy(b, "two"); show(std::string("c94_") + s); }
  { char b[32] = "one"; auto s = std::string(b); auto t = std::string("p") + b; strcpy(b, "two"); show(std::string("c95_") + s); show(std::string("c95_") + t); }
  { char b[32] = "one"; std::vector<std::string> v; v.push_back(b); v.emplace_back(b); v.insert(v.begin(), b); strcpy(b, "two"); for (auto & s : v) { show(std::string("c97_") + s); } }
  { char b[32] = "one"; std::set<std::string> v; v.insert(b); std::map<std::string, int> m; m.insert({b, 1}); m.emplace(b, 2); strcpy(b, "two"); show(std::string("c98_") + (*v.begin())); show(std::string("c98_") + (m.begin()->first + "m")); }
  { char b[32] = "one"; std::vector<std::string> v(2, b); std::vector<std::string> w{b}; std::array<std::string, 1> a{b}; strcpy(b, "two"); show(std::string("c99_") + v[1]); show(std::string("c99_") + (w[0] + "w")); show(std::string("c99_") + (a[0] + "a")); }
  { char b[32] = "one"; auto f = std::bind([](std::string s) { return s; }, b); show(std::string("c100_") + (f())); }
  { char b[32] = "one"; struct L { std::string a; char c[8]; }; L l{b, "in"}; strcpy(b, "two"); show(std::string("c101_") + l.a); show(std::string("c101_") + l.c); L k = l; k.c[0] = 'x'; show(std::string("c101_") + k.c); show(std::string("c101_") + l.c); }
  { char b[4][16]; for (int i = 0; i < 4; i++) { sprintf(b[i], "r%d", i); } for (auto & r : b) { show(std::string("c102_") + r); } std::vector<std::string> v(b, b + 4); show(std::string("c102_") + (v[2] + "v")); }
  { char b[32] = "one"; std::string s; s = b; strcpy(b, "two"); s = b; strcpy(b, "three"); show(std::string("c103_") + s); }
  { char b[32] = "one"; std::string s = "x"; s = "lit"; s = b; strcpy(b, "two"); show(std::string("c104_") + s); }
  { char b[32] = "one"; const char * s = "x"; s = "lit"; s = b; strcpy(b, "two"); show(std::string("c105_") + s); }
  { char b[32] = "one"; std::vector<std::string> v(1); v[0] = "lit"; v[0] = b; strcpy(b, "two"); show(std::string("c107_") + v[0]); std::string t(b, 2); show(std::string("c107_") + (t + "t")); b[0] = 'q'; std::string u(b, 2); show(std::string("c107_") + (u + "u")); }
  { char b[32] = "one"; const char * ps[2]; ps[0] = "lit"; ps[0] = b; strcpy(b, "two"); show(std::string("c108_") + ps[0]); }
  { char * p = kept(); *p = 'x'; show(std::string("kept_") + kept()); }
  { char * p = of_namespace(); p[1] = '_'; show(std::string("namespace_") + global_name); }
}
