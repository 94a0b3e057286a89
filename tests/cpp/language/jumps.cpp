// SPDX-License-Identifier: Apache-2.0

static void jump_0() {
  std::string s; int i = 0; again: s += 'g'; if (++i < 3) goto again; show("j0_" + s);
}
static void jump_1() {
  std::string s = "a"; if (s.size() == 1) goto out; s += "b"; out: show("j1_" + s);
}
static void jump_2() {
  std::string s = "a"; if (s.size() == 2) goto out; s += "b"; out: show("j2_" + s);
}
static void jump_3() {
  std::string s; int n = 0; {if (n) goto fail; s = "ok"; goto done;} fail: s = "fail"; done: show("j3_" + s);
}
static void jump_4() {
  std::string s; int n = 1; {if (n) goto fail; s = "ok"; goto done;} fail: s = "fail"; done: show("j4_" + s);
}
static void jump_5() {
  std::string s; for (int i = 0; i < 3; ++i) {for (int j = 0; j < 3; ++j) {s += "x"; if (i + j == 2) goto out;}} out: show("j5_" + s);
}
static void jump_6() {
  std::string s; int st = 0; start: switch (st) {case 0: s += "a"; st = 2; goto start; case 2: s += "c"; break;} show("j6_" + s);
}
static void jump_7() {
  std::string s; int i = 0; loop: if (i == 3) goto end; s += std::to_string(i); ++i; goto loop; end: show(std::string("j7_") + "n" + s);
}
static void jump_8() {
  std::string s; int i = 0; a: s += "a"; if (i++ < 1) goto b; goto c; b: s += "b"; goto a; c: show("j8_" + s);
}
static void jump_9() {
  std::string s; try {goto out; s = "no";} catch (...) {} out: s += "yes"; show("j9_" + s);
}
static void jump_10() {
  std::string s; for (int i = 0; i < 2; ++i) {retry: s += "r"; if (s.size() < 3) goto retry; s += "_";} show("j10_" + s);
}
static void jump_11() {
  std::string s; for (int i = 0; i < 3; ++i) {if (i == 1) goto next; s += std::to_string(i); next: ;} show(std::string("j11_") + "n" + s);
}
static void jump_12() {
  std::string s; for (int i = 0; i < 3; ++i) {if (i == 1) goto next; if (i == 2) break; s += std::to_string(i); next: s += "n";} show(std::string("j12_") + "n" + s);
}
static void jump_13() {
  std::string s = "q"; auto f = [&] {int k = 0; up: s += "l"; if (k++ < 1) goto up;}; f(); show("j13_" + s);
}
static void jump_14() {
  struct D {std::string * o; ~D() {*o += "d";}}; std::string s; int i = 0; up: {D d{&s}; if (i++ < 2) goto up;} show("j14_" + s);
}
static void jump_15() {
  std::string s; for (int i = 0; i < 2; ++i) {for (int j = 0; j < 3; ++j) {switch (j) {case 1: goto next; default: s += "d";}} next: s += "n"; if (i == 1) continue; s += "m";} show("j15_" + s);
}
static void jump_16() {
  std::string s; int i = 0; while (true) {if (i == 2) break; int j = 0; again: if (j++ < 2) {s += "w"; goto again;} ++i;} show("j16_" + s);
}
static void jump_17() {
  std::string s; int k = 0; top: for (const auto & x : std::vector<std::string>{"a", "b"}) {s += x; if (k++ == 0) goto top;} show("j17_" + s);
}
static void jump_18() {
  std::string s; do {if (s.size() > 2) goto stop; s += "z";} while (true); stop: show("j18_" + s);
}
static void jump_19() {
  std::string s; for (int i = 0; i < 2; ++i) {std::string t = "t"; for (int j = 0; j < 2; ++j) {if (j == 1) goto inner; s += t;} inner: s += "i";} show("j19_" + s);
}
static void jump_20() {
  unused: std::string s = "u"; show("j20_" + s);
}
static void jump_21() {
  std::string s; {int a = 0; again: s += "x"; if (++a < 3) goto again; if (a == 3) goto done; s += "never";} s += "mid"; done: show(std::string("j21_") + (s));
}
static void jump_22() {
  std::string s; int a = 0, b = 0; outer: s += "o"; {inner: s += "i"; if (++a == 1) goto inner; if (++b == 1) goto outer;} s += "t"; show(std::string("j22_") + (s));
}
static void jump_23() {
  std::string s; {int a = 0; again: s += "x"; if (++a < 2) goto again; for (;;) {if (a++ > 2) goto done; s += "k";}} s += "skip"; done: s += "y"; show(std::string("j23_") + (s));
}
static void jump_24() {
  std::string s; for (int i = 0; i < 2; ++i) {int k = 0; up: s += "u"; {int j = 0; in: if (j++ < 1) goto in; if (k++ < 1) goto up; if (i == 0) continue; s += "e";} s += "f";} show(std::string("j24_") + (s));
}
static void run() {
  jump_21();
  jump_22();
  jump_23();
  jump_24();
  jump_0();
  jump_1();
  jump_2();
  jump_3();
  jump_4();
  jump_5();
  jump_6();
  jump_7();
  jump_8();
  jump_9();
  jump_10();
  jump_11();
  jump_12();
  jump_13();
  jump_14();
  jump_15();
  jump_16();
  jump_17();
  jump_18();
  jump_19();
  jump_20();
}
