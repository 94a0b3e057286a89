// SPDX-License-Identifier: Apache-2.0
// The same for arrays of characters in fields.
#include <cstdio>
#include <cstring>

struct Holder { char * p; };
struct Rec { char name[8] = "rec"; int n = 0; };
template<typename T> void tmpl(T p) { *p = 'x'; }
template<typename T> void tmplref(T & p) { p[0] = 'x'; }
static void put_first(char * out) { *out = 'x'; }

struct Owner
{
  Rec rec_;
  char field_[8] = "abc";
  bool flag_ = true;
  std::string out_;
  void set_out(const char * c) { out_ = c; }
  void f0()
  { char * p = field_; *p = 'x'; show(std::string("c14_") + field_); }
  void f1()
  { char name[16] = "abc"; char a[8] = "one"; char * p = flag_ ? name : a; *p = 'x'; show(std::string("c40_") + name); show(std::string("c40_") + a); }
  void f2()
  { auto p = field_; *p = 'x'; show(std::string("c51_") + field_); }
  void f3()
  { auto * p = this->field_; p[1] = 'x'; show(std::string("c52_") + field_); }
  void f4()
  { char * p; p = field_; *p = 'x'; show(std::string("c53_") + field_); }
  void f5()
  { char * p = field_ + 1; *p = 'x'; show(std::string("c54_") + field_); }
  void f6()
  { put_first(field_ + 2); show(std::string("c55_") + field_); }
  void f7()
  { strcpy(field_ + 1, "ZZ"); show(std::string("c56_") + field_); }
  void f8()
  { *field_ = 'x'; show(std::string("c57_") + field_); }
  void f9()
  { char * p = (char *)field_; *p = 'x'; show(std::string("c58_") + field_); }
  void f10()
  { auto p = static_cast<char *>(field_); *p = 'x'; show(std::string("c59_") + field_); }
  void f11()
  { std::replace(field_, field_ + 3, 'b', '_'); show(std::string("c62_") + field_); }
  void f12()
  { char * c = strchr(field_, 'b'); if (c) { *c = '_'; } show(std::string("c63_") + field_); }
  void f13()
  { sprintf(field_ + strlen(field_), "%d", 5); show(std::string("c64_") + field_); }
  void f14()
  { snprintf(field_, sizeof(field_), "cam%d", 5); show(std::string("c65_") + field_); show(std::string("c65_") + (std::string("z") + field_)); std::string t = field_; show(std::string("c65_") + (t + "t")); }
  void f15()
  { tmpl(field_); show(std::string("c66_") + field_); char name[8] = "abc"; tmpl(name); show(std::string("c66_") + name); }
  void f16()
  { tmplref(field_); show(std::string("c67_") + field_); char name[8] = "abc"; tmplref(name); show(std::string("c67_") + name); }
  void f17()
  { Holder h{field_}; *h.p = 'x'; show(std::string("c68_") + field_); }
  void f18()
  { auto s = rec_.name; *s = 'x'; show(std::string("c69_") + rec_.name); Rec copy = rec_; copy.name[1] = 'y'; show(std::string("c69_") + copy.name); show(std::string("c69_") + rec_.name); }
  void f19()
  { Rec * r = &rec_; char * p = r->name; strcpy(p + 1, "q"); show(std::string("c70_") + r->name); }
  void f20()
  { char b[32] = "one"; set_out(b); strcpy(b, "two"); show(std::string("c89_") + out_); }
  void f21()
  { char b[32] = "one"; std::string s = flag_ ? b : "no"; strcpy(b, "two"); show(std::string("c96_") + s); }
  void f22()
  { char b[32] = "one"; out_ = "lit"; out_ = b; strcpy(b, "two"); show(std::string("c106_") + out_); }
};

static void run()
{
  Owner().f0();
  Owner().f1();
  Owner().f2();
  Owner().f3();
  Owner().f4();
  Owner().f5();
  Owner().f6();
  Owner().f7();
  Owner().f8();
  Owner().f9();
  Owner().f10();
  Owner().f11();
  Owner().f12();
  Owner().f13();
  Owner().f14();
  Owner().f15();
  Owner().f16();
  Owner().f17();
  Owner().f18();
  Owner().f19();
  Owner().f20();
  Owner().f21();
  Owner().f22();
}
